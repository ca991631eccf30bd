// SPDX-License-Identifier: MIT
#include "access/token.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>
#include <string>

namespace hedgehog::access {
namespace {

TEST(Token, Has256RandomBitsInCharactersThatNeedNoQuoting) {
  std::set<std::string> seen;
  for (int i = 0; i < 100; ++i) {
    const std::string token = new_token();
    EXPECT_THAT(token, testing::MatchesRegex("hht_[A-Za-z0-9_-]+"));
    EXPECT_EQ(token.size(), 4u + 43u) << "43 characters of 6 bits hold 256 bits";
    EXPECT_TRUE(seen.insert(token).second) << "a token came twice";
  }
}

TEST(Token, IsStoredAsItsSha256) {
  // FIPS 180-4's example, "abc".
  EXPECT_EQ(base::to_hex(digest_of("abc").bytes),
            "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
}

TEST(Token, DigestsAreTheSameOnlyWhenEveryBitIs) {
  const Digest digest = digest_of("a token");
  EXPECT_TRUE(digest == digest_of("a token"));
  for (std::size_t byte = 0; byte < digest.bytes.size(); ++byte) {
    for (int bit = 0; bit < 8; ++bit) {
      Digest other = digest;
      other.bytes[byte] = static_cast<unsigned char>(other.bytes[byte] ^ (1 << bit));
      EXPECT_FALSE(digest == other) << byte << " " << bit;
    }
  }
}

TEST(Token, NamesAreShortAndHaveNoBlanks) {
  for (const std::string& good :
       {std::string("arcade"), std::string("lab-2.left_hand"), std::string(32, 'a')})
    EXPECT_TRUE(is_token_name(good)) << good;
  for (const std::string& bad : {std::string(), std::string("two words"), std::string(33, 'a'),
                                 std::string("#x"), std::string("a\nb"), std::string("\xc3\xa4")})
    EXPECT_FALSE(is_token_name(bad)) << bad;
}

}  // namespace
}  // namespace hedgehog::access
