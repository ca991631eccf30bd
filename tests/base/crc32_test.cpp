// SPDX-License-Identifier: MIT
#include "base/crc32.h"

#include <gtest/gtest.h>

#include <string_view>

namespace hedgehog::base {
namespace {

TEST(Crc32, GivesTheCheckValueOfItsDefinition) {
  const std::string_view digits = "123456789";
  EXPECT_EQ(crc32(std::as_bytes(std::span(digits))), 0xCBF43926u);
  EXPECT_EQ(crc32({}), 0u);
}

}  // namespace
}  // namespace hedgehog::base
