// SPDX-License-Identifier: MIT
// Back-off after wrong tokens, in virtual time.
#include "daemon/server/session/failed_tokens.h"

#include <gtest/gtest.h>

#include <string>

namespace hedgehog::server {
namespace {

using F = FailedTokens;

void fail(FailedTokens& failed, const std::string& key, int times, model::Tick now = 0) {
  for (int i = 0; i < times; ++i) failed.failed(key, now);
}

TEST(FailedTokens, AFewCauseNoWait) {
  FailedTokens failed;
  fail(failed, "a", F::kFree);
  EXPECT_EQ(failed.remaining("a", 0), 0);
  failed.failed("a", 0);
  EXPECT_EQ(failed.remaining("a", 0), F::kFirstWait);
}

TEST(FailedTokens, EachFurtherOneWaitsTwiceAsLongUpToAMinute) {
  FailedTokens failed;
  fail(failed, "a", F::kFree);
  model::Tick now = 0;
  for (const model::Tick wait : {1'000, 2'000, 4'000, 8'000, 16'000, 32'000, 60'000, 60'000}) {
    failed.failed("a", now);
    EXPECT_EQ(failed.remaining("a", now), wait);
    EXPECT_EQ(failed.remaining("a", now + wait - 1), 1);
    now += wait;
    EXPECT_EQ(failed.remaining("a", now), 0);
  }
  fail(failed, "a", 1000, now);
  EXPECT_EQ(failed.remaining("a", now), F::kMaxWait);
}

TEST(FailedTokens, OtherAddressesAndSuccessesCauseNoWait) {
  FailedTokens failed;
  fail(failed, "a", 10);
  EXPECT_EQ(failed.remaining("b", 0), 0);
  failed.succeeded("a");
  EXPECT_EQ(failed.remaining("a", 0), 0);
  EXPECT_EQ(failed.size(), 0u);
}

TEST(FailedTokens, ExpireAfterTenMinutes) {
  FailedTokens failed;
  fail(failed, "a", F::kFree + 5);
  failed.failed("a", F::kMemory + 1);
  EXPECT_EQ(failed.remaining("a", F::kMemory + 1), 0) << "it counts from one again";
}

TEST(FailedTokens, OfTooManyAddressesTheOldestIsRemoved) {
  FailedTokens failed;
  for (std::size_t i = 0; i < F::kMaxAddresses; ++i)
    fail(failed, std::to_string(i), F::kFree + 1, static_cast<model::Tick>(i));
  const model::Tick now = static_cast<model::Tick>(F::kMaxAddresses);
  fail(failed, "0", 1, now);  // now the newest
  failed.failed("another", now + 1);
  EXPECT_EQ(failed.size(), F::kMaxAddresses);
  EXPECT_GT(failed.remaining("0", now), 0);
  EXPECT_EQ(failed.remaining("1", now), 0) << "it had the oldest failure";
  EXPECT_GT(failed.remaining("2", now), 0);
}

TEST(FailedTokens, CountByHostAndInIpv6ByNetwork) {
  EXPECT_EQ(F::key_of("192.0.2.7:5000"), "192.0.2.7");
  EXPECT_EQ(F::key_of("192.0.2.7:5001"), F::key_of("192.0.2.7:5000"));
  EXPECT_NE(F::key_of("192.0.2.8:5000"), F::key_of("192.0.2.7:5000"));
  EXPECT_EQ(F::key_of("[2001:db8:1:2::1]:9"), F::key_of("[2001:db8:1:2:ffff::9]:8"));
  EXPECT_NE(F::key_of("[2001:db8:1:2::1]:9"), F::key_of("[2001:db8:1:3::1]:9"));
  EXPECT_EQ(F::key_of("[::ffff:192.0.2.7]:5000"), "192.0.2.7");
}

}  // namespace
}  // namespace hedgehog::server
