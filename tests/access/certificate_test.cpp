// SPDX-License-Identifier: MIT
#include "access/certificate.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

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

}  // namespace
}  // namespace hedgehog::access
