// SPDX-License-Identifier: MIT
#include "base/spelling.h"

#include <gtest/gtest.h>

#include <array>

namespace hedgehog::base {
namespace {

constexpr std::array<std::string_view, 4> kNames{"pulse", "--lease-ms", "--level", "duration_ms"};

TEST(Spelling, FindsTheNearestName) {
  EXPECT_EQ(nearest("pulze", kNames), "pulse");
  EXPECT_EQ(nearest("--levle", kNames), "--level");
  EXPECT_EQ(nearest("duration", kNames), "duration_ms") << "only the unit is missing";
  EXPECT_EQ(nearest("--lease", kNames), "--lease-ms");
}

TEST(Spelling, FindsNothingWhereNothingIsNear) {
  EXPECT_EQ(nearest("frobnicate", kNames), "");
  EXPECT_EQ(nearest("", kNames), "");
  EXPECT_EQ(nearest(std::string(65, 'p'), kNames), "");
  EXPECT_EQ(nearest("pulse", {}), "");
}

}  // namespace
}  // namespace hedgehog::base
