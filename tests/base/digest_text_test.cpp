// SPDX-License-Identifier: MIT
#include "base/digest_text.h"

#include <gtest/gtest.h>

#include <string>

namespace hedgehog::base {
namespace {

TEST(DigestText, DigestsAreReadAsTheyAreWrittenAndAsOtherToolsWriteThem) {
  Sha256 digest{};
  for (std::size_t i = 0; i < digest.size(); ++i)
    digest[i] = static_cast<unsigned char>(37 * i + 11);
  const std::string plain = to_hex(digest);
  EXPECT_EQ(parse_sha256(plain), digest);
  std::string colons;
  for (std::size_t i = 0; i < plain.size(); i += 2) {
    if (i > 0) colons += ':';
    for (const char c : plain.substr(i, 2))
      colons += static_cast<char>(c >= 'a' ? c - 'a' + 'A' : c);
  }
  EXPECT_EQ(parse_sha256(colons), digest) << colons;
  for (const std::string& wrong :
       {std::string(), plain.substr(1), plain + "0", "g" + plain.substr(1), plain.substr(2) + ":a",
        colons.substr(0, 2) + "-" + colons.substr(3), colons + ":"})
    EXPECT_EQ(parse_sha256(wrong), std::nullopt) << wrong;
}

}  // namespace
}  // namespace hedgehog::base
