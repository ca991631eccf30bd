// SPDX-License-Identifier: MIT
#include "clients/lib/tls_stream.h"

#include <openssl/crypto.h>
#include <openssl/ssl.h>
#include <openssl/x509.h>

#include <boost/asio/ip/address.hpp>
#include <boost/asio/ssl/host_name_verification.hpp>

namespace hedgehog::client {

namespace ssl = boost::asio::ssl;

TlsStream::TlsStream(Socket& socket, const Address& address)
    : fingerprint_(address.fingerprint),
      context_(ssl::context::tls_client),
      stream_(socket, [&]() -> ssl::context& {
        SSL_CTX_set_min_proto_version(context_.native_handle(), TLS1_3_VERSION);
        if (!fingerprint_) context_.set_default_verify_paths();
        return context_;
      }()) {
  boost::system::error_code no_address;
  boost::asio::ip::make_address(address.host, no_address);
  if (no_address) SSL_set_tlsext_host_name(stream_.native_handle(), address.host.c_str());
  // A fingerprint is compared after the handshake and replaces the authorities.
  stream_.set_verify_mode(fingerprint_ ? ssl::verify_none : ssl::verify_peer);
  if (!fingerprint_) stream_.set_verify_callback(ssl::host_name_verification(address.host));
}

std::string TlsStream::verify_problem() {
  if (!fingerprint_) return {};
  X509* const certificate = SSL_get1_peer_certificate(stream_.native_handle());
  base::Sha256 digest{};
  unsigned int size = 0;
  const bool good = certificate != nullptr &&
                    X509_digest(certificate, EVP_sha256(), digest.data(), &size) == 1 &&
                    size == digest.size();
  X509_free(certificate);
  if (!good) return "it has no certificate";
  if (CRYPTO_memcmp(digest.data(), fingerprint_->data(), digest.size()) == 0) return {};
  return "its certificate has another fingerprint: " + base::to_hex(digest);
}

}  // namespace hedgehog::client
