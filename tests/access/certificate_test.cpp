// SPDX-License-Identifier: MIT
#include "access/certificate.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <openssl/bio.h>
#include <openssl/evp.h>
#include <openssl/pem.h>
#include <openssl/rsa.h>

#include <memory>
#include <string>

namespace hedgehog::access {
namespace {

TEST(Certificate, IsNewEachTimeAndFitsItsKey) {
  const Certificate one = new_certificate("ball-host", 30);
  const Certificate two = new_certificate("192.0.2.7", 30);
  EXPECT_EQ(pair_problem(one.certificate_pem, one.key_pem), "");
  EXPECT_EQ(pair_problem(two.certificate_pem, two.key_pem), "");
  const auto first = fingerprint_of(one.certificate_pem);
  const auto second = fingerprint_of(two.certificate_pem);
  ASSERT_TRUE(first && second);
  EXPECT_NE(*first, *second);
}

TEST(Certificate, OfAnotherKeyOrNoneIsRejected) {
  const Certificate one = new_certificate("a", 1);
  const Certificate two = new_certificate("a", 1);
  EXPECT_THAT(pair_problem(one.certificate_pem, two.key_pem), testing::HasSubstr("another"));
  EXPECT_THAT(pair_problem("", one.key_pem), testing::HasSubstr("certificate"));
  EXPECT_THAT(pair_problem(one.certificate_pem, ""), testing::HasSubstr("key"));
  EXPECT_THAT(pair_problem(one.key_pem, one.key_pem), testing::HasSubstr("certificate"));
  EXPECT_FALSE(fingerprint_of(one.key_pem));
}

std::string rsa_key_pem(unsigned bits) {
  const std::unique_ptr<EVP_PKEY, decltype(&EVP_PKEY_free)> key(EVP_RSA_gen(bits), &EVP_PKEY_free);
  const std::unique_ptr<BIO, decltype(&BIO_free_all)> text(BIO_new(BIO_s_mem()), &BIO_free_all);
  EXPECT_EQ(
      PEM_write_bio_PKCS8PrivateKey(text.get(), key.get(), nullptr, nullptr, 0, nullptr, nullptr),
      1);
  char* bytes = nullptr;
  const long size = BIO_get_mem_data(text.get(), &bytes);
  return {bytes, static_cast<std::size_t>(size)};
}

// OpenSSL would refuse the certificate at the daemon's start.
TEST(Certificate, OfAKeyThatOpenSslRefusesIsRejected) {
  const std::string certificate = new_certificate("a", 1).certificate_pem;
  EXPECT_THAT(pair_problem(certificate, rsa_key_pem(1024)),
              testing::HasSubstr("80 bits of security, 112 are needed"));
  EXPECT_THAT(pair_problem(certificate, rsa_key_pem(2048)), testing::HasSubstr("another"));
}

}  // namespace
}  // namespace hedgehog::access
