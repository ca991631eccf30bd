// SPDX-License-Identifier: MIT
#include "daemon/server/net/tls_context.h"

#include <openssl/ssl.h>

#include <boost/asio/buffer.hpp>
#include <stdexcept>

namespace hedgehog::server {

TlsContext make_tls_context(const config::AccessSettings& access) {
  namespace ssl = boost::asio::ssl;
  if (access.certificate_pem.empty()) return nullptr;
  auto context = std::make_shared<ssl::context>(ssl::context::tls_server);
  SSL_CTX* const native = context->native_handle();
  SSL_CTX_set_options(native, SSL_OP_NO_RENEGOTIATION | SSL_OP_NO_TICKET);
  SSL_CTX_set_session_cache_mode(native, SSL_SESS_CACHE_OFF);
  if (SSL_CTX_set_min_proto_version(native, TLS1_3_VERSION) != 1 ||
      SSL_CTX_set_num_tickets(native, 0) != 1 || SSL_CTX_set_max_early_data(native, 0) != 1)
    throw std::runtime_error("OpenSSL has no TLS 1.3");
  context->use_certificate_chain(boost::asio::buffer(access.certificate_pem));
  context->use_private_key(boost::asio::buffer(access.key_pem), ssl::context::pem);
  return context;
}

}  // namespace hedgehog::server
