// SPDX-License-Identifier: MIT
#include "base/number_text.h"

#include <gtest/gtest.h>

#include <limits>

namespace hedgehog::base {
namespace {

TEST(Fixed, HasThatManyDecimalsAndNoSignOfZero) {
  EXPECT_EQ(fixed(41.25, 1), "41.2");
  EXPECT_EQ(fixed(-0.06, 1), "-0.1");
  EXPECT_EQ(fixed(-0.04, 1), "0.0");
  EXPECT_EQ(fixed(-0.5, 0), "0");
  EXPECT_EQ(fixed(1e16, 0), "10000000000000000");
  EXPECT_EQ(fixed(std::numeric_limits<double>::quiet_NaN(), 2), "nan");
  EXPECT_EQ(fixed(-std::numeric_limits<double>::infinity(), 2), "-inf");
}

TEST(Grouped, SeparatesThousands) {
  EXPECT_EQ(grouped(-0.3), "0");
  EXPECT_EQ(grouped(-431), "-431");
  EXPECT_EQ(grouped(4310), "4 310");
  EXPECT_EQ(grouped(-1234567.4, ','), "-1,234,567");
}

TEST(Shortest, ReadsBackExactly) {
  EXPECT_EQ(shortest(0.1), "0.1");
  EXPECT_EQ(shortest(100000), "1e+05");
  EXPECT_EQ(shortest(-std::numeric_limits<double>::denorm_min()), "-5e-324");
}

}  // namespace
}  // namespace hedgehog::base
