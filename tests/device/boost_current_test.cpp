// SPDX-License-Identifier: MIT
// The current after a step of the set-point, when the host sends the next one in time and when it
// is late.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "daemon/device/simulator/lock_step.h"
#include "tests/device/exact_board.h"
#include "tests/device/limited.h"

namespace hedgehog::device {
namespace {

struct StepOfCurrent : testing::Test {
  LinkPort port;
  LockStep both{port, exact()};
  LinkCommand command;

  double current() { return both.board().plant().current_a().x; }
  bool awake() { return both.board().core().outputs().awake; }

  // A new set-point that requests `requested` while `now` flows.
  void renew(double requested, double now) {
    const std::uint8_t arm_count = command.board.arm_count;
    command.board =
        BoardCommand::drive(limited({requested, 0, 0}), kColdOhm, 1.5e-3, {now, 0, 0}, 12.0);
    command.board.arm_count = arm_count;
    ++command.count;
  }
  void step() {
    port.commands.write(command);
    both.step();
  }
  void SetUp() override {
    for (int ms = 0; ms < 6; ++ms) {
      renew(0, 0);
      if (ms == 2) ++command.board.arm_count;
      step();
    }
    ASSERT_TRUE(awake());
  }
  // The peak current from one set-point, until the link has made the board safe.
  double peak_of_one(double requested) {
    renew(requested, 0.0);
    double peak = 0.0;
    int ms = 0;
    for (; ms < 100 && (ms == 0 || awake()); ++ms) {
      step();
      peak = std::max(peak, current());
    }
    EXPECT_EQ(ms, Link::kOverdueTicks + 1);
    return peak;
  }
};

TEST_F(StepOfCurrent, EightAmperesNeverRenewedStayEight) {
  const double peak = peak_of_one(8.0);
  EXPECT_LT(peak, 8.2);
  EXPECT_GT(peak, 7.9);
}

TEST_F(StepOfCurrent, FifteenAmperesNeverRenewedStayFifteen) {
  const double peak = peak_of_one(15.0);
  EXPECT_LT(peak, 15.3);
  EXPECT_GT(peak, 14.8);
}

TEST_F(StepOfCurrent, RenewedEachMillisecondItIsThereInTwo) {
  for (const double requested : {8.0, -8.0, 3.0, 8.0, 0.0}) {
    double peak = 0.0;
    const double from = current();
    for (int ms = 1; ms <= 20; ++ms) {
      renew(requested, current());
      step();
      // 12 V move the current by up to 6.9 A in the first millisecond: from 8 to -8 takes three.
      if (ms >= (std::abs(requested - from) > 12.0 ? 3 : 2))
        ASSERT_NEAR(current(), requested, 0.02 * 8.0) << ms;
      peak = std::max(peak, std::abs(current() - from));
    }
    EXPECT_LT(peak, 1.02 * std::abs(requested - from)) << requested;
  }
}

}  // namespace
}  // namespace hedgehog::device
