// SPDX-License-Identifier: MIT
// Two board frames as one measurement, and which of their currents determine a resistance.
#include "daemon/control/checks/telemetry_pair.h"

#include <gtest/gtest.h>

#include <limits>

namespace hedgehog::control {
namespace {

/// Consecutive frames of awake bridges at 12 V, without signs of the currents.
struct Frames {
  TelemetryPair pair;
  device::BoardTelemetry board;

  Frames() {
    board.accuracy = model::kDriverCsAccuracy;
    board.supply_v = 12.0;
    board.before.known = board.before.bridges_awake = board.bridges_awake = true;
  }
  void step(double current_a, bool fresh = true) {
    board.current_a.y = current_a;
    board.duty.y = current_a / 30.0;
    if (fresh) ++board.sequence;
    pair.step(fresh, board);
    if (fresh) board.before = {true, board.bridges_awake, board.current_a, board.measured};
  }
  bool informative() const { return pair.informative()[1]; }
};

TEST(TelemetryPair, HasTheVoltageAndTheCurrentsAtBothEndsOfTheMillisecond) {
  Frames frames;
  frames.step(3.0);
  frames.step(6.0);
  EXPECT_TRUE(frames.pair.consecutive());
  EXPECT_TRUE(frames.pair.follows());
  EXPECT_TRUE(frames.pair.electrical());
  EXPECT_EQ(frames.pair.before_a().y, 3.0);
  EXPECT_EQ(frames.pair.after_a().y, 6.0);
  EXPECT_DOUBLE_EQ(frames.pair.voltage_v().y, 12.0 * 6.0 / 30.0);
}

TEST(TelemetryPair, KeepsTheLastFrameInATickWithoutOne) {
  Frames frames;
  frames.step(3.0);
  frames.step(6.0);
  frames.step(9.0, false);
  EXPECT_FALSE(frames.pair.fresh());
  EXPECT_FALSE(frames.pair.consecutive());
  EXPECT_FALSE(frames.pair.electrical());
  EXPECT_EQ(frames.pair.before_a().y, 3.0);
  EXPECT_EQ(frames.pair.after_a().y, 6.0);
  frames.step(6.0);
  EXPECT_TRUE(frames.pair.follows()) << "no frame is missing";
}

TEST(TelemetryPair, AMissingFrameDoesNotFollow) {
  Frames frames;
  frames.step(3.0);
  ++frames.board.sequence;
  frames.step(3.0);
  EXPECT_TRUE(frames.pair.consecutive()) << "the link has the frame before";
  EXPECT_FALSE(frames.pair.follows());
}

TEST(TelemetryPair, WithoutTheFrameBeforeBothEndsAreThePresentCurrent) {
  Frames frames;
  frames.step(3.0);
  frames.board.before = {};
  frames.board.before.measured = {false, false, false};
  frames.step(6.0);
  EXPECT_FALSE(frames.pair.consecutive());
  EXPECT_EQ(frames.pair.before_a().y, 6.0);
  EXPECT_TRUE(frames.pair.measured()[1]);
}

TEST(TelemetryPair, NumbersThatAreNotFiniteAreNoFrame) {
  const double bad = std::numeric_limits<double>::quiet_NaN();
  Frames frames;
  frames.step(3.0);
  frames.step(bad);
  EXPECT_FALSE(frames.pair.fresh());
  EXPECT_EQ(frames.pair.after_a().y, 3.0);
}

TEST(TelemetryPair, BridgesThatSleptBeforeGiveNoResistance) {
  Frames frames;
  frames.board.before.bridges_awake = false;
  frames.step(3.0);
  EXPECT_TRUE(frames.pair.consecutive());
  EXPECT_FALSE(frames.pair.electrical());
}

TEST(TelemetryPair, ACurrentIsMeasuredIfItWasAtBothEnds) {
  Frames frames;
  frames.step(3.0);
  frames.board.before.measured[1] = false;
  frames.step(3.0);
  EXPECT_FALSE(frames.pair.measured()[1]);
  EXPECT_TRUE(frames.pair.after_measured()[1]);
  frames.board.measured[1] = false;
  frames.step(3.0);
  EXPECT_FALSE(frames.pair.after_measured()[1]);
}

/// Frames of `current_a` until it determines a resistance.
int frames_until_informative(Frames& frames, double current_a) {
  int count = 0;
  while (!frames.informative() && count < 100) {
    frames.step(current_a);
    ++count;
  }
  return count;
}

TEST(TelemetryPair, WithoutSignsACurrentMustHaveFlowedOneWayForFiveTimeConstants) {
  Frames frames;
  frames.step(0.0);
  frames.step(0.5);
  ASSERT_FALSE(frames.informative());
  EXPECT_EQ(frames_until_informative(frames, 0.5), 17);
  frames.step(0.0);
  EXPECT_FALSE(frames.informative()) << "no current has no direction";
  frames.step(0.5);
  EXPECT_EQ(frames_until_informative(frames, 0.5), 17);
  frames.step(-0.5);
  EXPECT_FALSE(frames.informative());
}

TEST(TelemetryPair, WithSignsEachMeasuredCurrentDeterminesAResistance) {
  Frames frames;
  frames.board.accuracy = model::kInLineAccuracy;
  frames.step(0.5);
  EXPECT_TRUE(frames.informative());
  frames.step(-0.5);
  EXPECT_TRUE(frames.informative());
}

}  // namespace
}  // namespace hedgehog::control
