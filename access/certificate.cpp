// SPDX-License-Identifier: MIT
#include "access/certificate.h"

#include <arpa/inet.h>
#include <openssl/bio.h>
#include <openssl/ec.h>
#include <openssl/evp.h>
#include <openssl/pem.h>
#include <openssl/rand.h>
#include <openssl/x509.h>
#include <openssl/x509v3.h>

#include <memory>
#include <stdexcept>
#include <string>

namespace hedgehog::access {
namespace {

template <auto free_function>
struct Free {
  template <class T>
  void operator()(T* object) const noexcept {
    free_function(object);
  }
};
using Bio = std::unique_ptr<BIO, Free<BIO_free_all>>;
using Key = std::unique_ptr<EVP_PKEY, Free<EVP_PKEY_free>>;
using X509Object = std::unique_ptr<X509, Free<X509_free>>;
using Extension = std::unique_ptr<X509_EXTENSION, Free<X509_EXTENSION_free>>;

constexpr long kSecondsPerDay = 86'400;
/// Of OpenSSL's security level 2, Debian's default: with less no connection could be served.
constexpr int kMinSecurityBits = 112;

void require(bool good) {
  if (!good) throw std::runtime_error("OpenSSL cannot make a certificate");
}

Bio bio_of(std::string_view text) {
  return Bio(BIO_new_mem_buf(text.data(), static_cast<int>(text.size())));
}

std::string text_of(BIO* bio) {
  char* bytes = nullptr;
  const long size = BIO_get_mem_data(bio, &bytes);
  return {bytes, static_cast<std::size_t>(size)};
}

/// Prevents a password prompt on the terminal for an encrypted key.
int no_password(char*, int, int, void*) { return 0; }

X509Object certificate_of(std::string_view pem) {
  return X509Object(PEM_read_bio_X509(bio_of(pem).get(), nullptr, no_password, nullptr));
}

bool is_address(const std::string& name) {
  unsigned char bytes[16];
  return inet_pton(AF_INET, name.c_str(), bytes) == 1 ||
         inet_pton(AF_INET6, name.c_str(), bytes) == 1;
}

void add_extension(X509* certificate, int id, const std::string& value) {
  const Extension extension(X509V3_EXT_conf_nid(nullptr, nullptr, id, value.c_str()));
  require(extension && X509_add_ext(certificate, extension.get(), -1) == 1);
}

void set_serial(X509* certificate) {
  unsigned char bytes[8];
  require(RAND_bytes(bytes, sizeof bytes) == 1);
  bytes[0] = static_cast<unsigned char>((bytes[0] & 0x7f) | 0x40);  // positive, fixed length
  const std::unique_ptr<BIGNUM, Free<BN_free>> number(BN_bin2bn(bytes, sizeof bytes, nullptr));
  require(number &&
          BN_to_ASN1_INTEGER(number.get(), X509_get_serialNumber(certificate)) != nullptr);
}

}  // namespace

Certificate new_certificate(const std::string& name, int days) {
  const Key key(EVP_EC_gen("P-256"));
  const X509Object certificate(X509_new());
  require(key && certificate && X509_set_version(certificate.get(), 2) == 1);
  set_serial(certificate.get());
  require(X509_gmtime_adj(X509_getm_notBefore(certificate.get()), 0) != nullptr &&
          X509_gmtime_adj(X509_getm_notAfter(certificate.get()), days * kSecondsPerDay) !=
              nullptr &&
          X509_set_pubkey(certificate.get(), key.get()) == 1);
  X509_NAME* subject = X509_get_subject_name(certificate.get());
  require(X509_NAME_add_entry_by_txt(subject, "CN", MBSTRING_UTF8,
                                     reinterpret_cast<const unsigned char*>(name.c_str()), -1, -1,
                                     0) == 1 &&
          X509_set_issuer_name(certificate.get(), subject) == 1);
  add_extension(certificate.get(), NID_basic_constraints, "critical,CA:FALSE");
  add_extension(certificate.get(), NID_key_usage, "critical,digitalSignature");
  add_extension(certificate.get(), NID_ext_key_usage, "serverAuth");
  add_extension(certificate.get(), NID_subject_alt_name,
                (is_address(name) ? "IP:" : "DNS:") + name);
  require(X509_sign(certificate.get(), key.get(), EVP_sha256()) > 0);

  const Bio certificate_text(BIO_new(BIO_s_mem()));
  const Bio key_text(BIO_new(BIO_s_mem()));
  require(certificate_text && key_text &&
          PEM_write_bio_X509(certificate_text.get(), certificate.get()) == 1 &&
          PEM_write_bio_PKCS8PrivateKey(key_text.get(), key.get(), nullptr, nullptr, 0, nullptr,
                                        nullptr) == 1);
  return {text_of(certificate_text.get()), text_of(key_text.get())};
}

boost::system::result<base::Sha256, std::string> fingerprint_of(std::string_view certificate_pem) {
  const X509Object certificate = certificate_of(certificate_pem);
  if (!certificate) return std::string("has no certificate in PEM");
  base::Sha256 digest{};
  unsigned int size = 0;
  if (X509_digest(certificate.get(), EVP_sha256(), digest.data(), &size) != 1 ||
      size != digest.size())
    return std::string("has a certificate that OpenSSL cannot encode");
  return digest;
}

std::string pair_problem(std::string_view certificate_pem, std::string_view key_pem) {
  const X509Object certificate = certificate_of(certificate_pem);
  if (!certificate) return "the certificate is not in PEM";
  const Key key(PEM_read_bio_PrivateKey(bio_of(key_pem).get(), nullptr, no_password, nullptr));
  if (!key) return "the key is not in PEM, or has a password";
  if (const int bits = EVP_PKEY_get_security_bits(key.get()); bits < kMinSecurityBits)
    return "the key is too weak: " + std::to_string(bits) + " bits of security, " +
           std::to_string(kMinSecurityBits) + " are needed (RSA of 2048 bits, or P-256)";
  if (X509_check_private_key(certificate.get(), key.get()) != 1)
    return "the key is that of another certificate";
  return {};
}

}  // namespace hedgehog::access
