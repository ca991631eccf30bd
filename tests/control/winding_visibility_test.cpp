// SPDX-License-Identifier: MIT
// Whether the windings' V/I is being measured.
#include "daemon/control/winding_visibility.h"

#include <gtest/gtest.h>

#include "model/tick.h"

namespace hedgehog::control {
namespace {

/// A board whose windings carry current in every tick, until a test changes it.
struct Seen {
  device::BoardTelemetry board;
  WindingVisibility visibility;
  bool fresh = true;
  bool awake = true;
  bool driving = true;
  /// The frame before was received.
  bool paired = true;
  model::Vec3 predicted_a{5.0, 5.0, 5.0};

  Seen() { board.current_a = predicted_a; }
  void run(int ticks) {
    for (int tick = 0; tick < ticks; ++tick) {
      board.before = {paired, awake, board.current_a, board.measured};
      ++board.sequence;
      pair_.step(fresh, board);
      visibility.step(pair_, awake, driving, predicted_a, model::kTickSeconds);
    }
  }
  bool all_lost() const { return visibility.lost(0) && visibility.lost(1) && visibility.lost(2); }
  bool any_lost() const { return visibility.lost(0) || visibility.lost(1) || visibility.lost(2); }

 private:
  TelemetryPair pair_;
};

TEST(WindingVisibility, EveryWindingIsSeenWhileItsCurrentIsMeasured) {
  Seen seen;
  seen.run(5000);
  EXPECT_FALSE(seen.any_lost());
  EXPECT_EQ(seen.visibility.asleep_s(), 0.0);
}

TEST(WindingVisibility, TheBridgesHaveSleptSinceTheirLastDrivenFrame) {
  Seen seen;
  seen.run(10);
  seen.awake = seen.driving = false;
  seen.run(200);
  EXPECT_NEAR(seen.visibility.asleep_s(), 0.2, 1e-9);
  seen.fresh = false;
  seen.run(1);
  EXPECT_EQ(seen.visibility.asleep_s(), 0.0) << "telemetry that is lost shows nothing";
  seen.fresh = true;
  seen.run(50);
  EXPECT_NEAR(seen.visibility.asleep_s(), 0.05, 1e-9);
  seen.awake = true;
  seen.run(1);
  EXPECT_EQ(seen.visibility.asleep_s(), 0.0);
}

TEST(WindingVisibility, WithoutTwoConsecutiveFramesAllAreLostAfterHalfASecond) {
  Seen seen;
  seen.predicted_a = {};
  seen.paired = false;
  seen.run(495);
  EXPECT_FALSE(seen.any_lost());
  seen.run(10);
  EXPECT_TRUE(seen.all_lost());
  seen.driving = false;
  seen.paired = true;
  seen.run(1000);
  EXPECT_TRUE(seen.all_lost()) << "only what is driven can be measured";
  seen.driving = true;
  seen.run(495);
  EXPECT_TRUE(seen.all_lost());
  seen.run(10);
  EXPECT_FALSE(seen.any_lost());
}

TEST(WindingVisibility, UnpairedFramesOfABoardThatIsNotDrivenLoseNothing) {
  Seen seen;
  seen.predicted_a = {};
  seen.driving = seen.paired = false;
  seen.run(2000);
  EXPECT_FALSE(seen.any_lost());
}

TEST(WindingVisibility, AWindingWhoseCurrentIsNotMeasuredIsLostAlone) {
  for (int coil = 0; coil < model::kCoils; ++coil) {
    Seen seen;
    seen.board.measured[static_cast<std::size_t>(coil)] = false;
    seen.run(495);
    EXPECT_FALSE(seen.any_lost());
    seen.run(10);
    for (int other = 0; other < model::kCoils; ++other)
      EXPECT_EQ(seen.visibility.lost(other), other == coil);
    seen.board.measured[static_cast<std::size_t>(coil)] = true;
    seen.run(20);
    EXPECT_FALSE(seen.any_lost());
  }
}

TEST(WindingVisibility, ACurrentWhileTheBridgesSleepMeasuresNoResistance) {
  Seen seen;
  seen.awake = false;
  seen.run(510);
  EXPECT_TRUE(seen.all_lost());
}

TEST(WindingVisibility, AWindingWithLittleCurrentIsNotLost) {
  Seen seen;
  seen.board.measured = {false, false, false};
  seen.predicted_a = {1.4, 1.6, -1.6};
  seen.run(600);
  EXPECT_FALSE(seen.visibility.lost(0));
  EXPECT_TRUE(seen.visibility.lost(1));
  EXPECT_TRUE(seen.visibility.lost(2));
}

// 5 A count as driven for 0.12 s, so that the zero crossings of a vibration do not interrupt it.
TEST(WindingVisibility, AVibrationIsDrivenThroughItsZeroCrossings) {
  for (const int every : {100, 200}) {
    Seen seen;
    seen.board.measured = {false, false, false};
    for (int pulse = 0; pulse < 20; ++pulse) {
      seen.predicted_a = {5.0, 5.0, 5.0};
      seen.run(1);
      seen.predicted_a = {};
      seen.run(every - 1);
      if (seen.all_lost()) break;
    }
    EXPECT_EQ(seen.all_lost(), every == 100) << every;
  }
}

}  // namespace
}  // namespace hedgehog::control
