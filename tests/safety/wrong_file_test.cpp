// SPDX-License-Identifier: MIT
// A device file with resistances that differ from the ball's: each winding's temperature is derived
// from them, so a wrong one must not let a winding burn before a calibration.
#include "tests/safety/safe.h"

namespace hedgehog::safety {
namespace {

using control::Reason;

struct Outcome {
  double hottest_c = 0.0;
  double seconds = 0.0;
  Reason reason = Reason::kNone;
};

/// Holds `requested_a` in `winding`, whose resistance is `share` times that of the file.
Outcome held(int winding, double share, double requested_a, int max_s, double ambient_c = 25.0,
             int thermistors = 3) {
  rig::RigOptions options;
  options.board.front_end.thermistors = thermistors;
  options.board.plant.r25_ohm[static_cast<std::size_t>(winding)] *= share;
  options.board.ambient_c = options.board.start_c = ambient_c;
  options.control.start.winding_c.fill(ambient_c);
  options.control.start.core_c = options.control.start_ambient_c = ambient_c;
  rig::Rig rig(options);
  rig.run_until_armed();
  model::Vec3 along{};
  along[winding] = 1.0;
  const auto effect = rig.start(rig::hold(along, requested_a));
  Outcome outcome;
  while (outcome.seconds < max_s && rig.controller().state() == control::State::kArmed) {
    rig.update(effect, rig::hold(along, requested_a));
    rig.run(500);
    outcome.seconds += 0.5;
    outcome.hottest_c = std::max(outcome.hottest_c, rig.plant().hottest_winding_c());
  }
  outcome.reason = rig.controller().reason();
  return outcome;
}

TEST(WrongFile, TooLittleResistanceStopsTheBallBeforeItIsWarm) {
  for (const int winding : {0, 1, 2}) {
    for (const double share : {0.5, 0.7, 0.8, 0.9}) {
      for (const double requested_a : {3.0, 5.0, 8.0, 12.0}) {
        const Outcome outcome = held(winding, share, requested_a, 10, 25.0, 1);
        EXPECT_TRUE(outcome.reason == Reason::kMeasurementsDisagree ||
                    outcome.reason == Reason::kCurrentMismatch)
            << winding << " x" << share << " " << requested_a << ": " << name(outcome.reason);
        EXPECT_LT(outcome.seconds, 1.6) << winding << " x" << share << " " << requested_a;
        EXPECT_LT(outcome.hottest_c, 30.0) << winding << " x" << share << " " << requested_a;
      }
    }
  }
}

TEST(WrongFile, TooMuchResistanceIsTreatedAsHeat) {
  for (const double share : {1.2, 2.0})
    for (const double requested_a : {5.0, 15.0})
      EXPECT_LT(held(1, share, requested_a, 10).seconds, 1.1) << share << " " << requested_a;
}

// The resistance is measured at each cold start, so a small error of the file has no effect.
TEST(WrongFile, FivePercentAreTolerated) {
  for (const int thermistors : {1, 3}) {
    for (const int winding : {0, 1, 2}) {
      const Outcome outcome = held(winding, 0.95, 12.0, 120, 25.0, thermistors);
      EXPECT_EQ(name(outcome.reason), "none") << winding << " " << thermistors;
      EXPECT_LT(outcome.hottest_c, 69.0) << winding << " " << thermistors;
    }
  }
}

TEST(WrongFile, ARightOneAndAColdAmbientAreNoFault) {
  for (const double ambient_c : {5.0, 25.0}) {
    for (const double share : {0.97, 1.0, 1.03}) {
      for (const double requested_a : {1.6, 5.0, 15.0}) {
        const Outcome outcome = held(1, share, requested_a, 20, ambient_c);
        EXPECT_EQ(name(outcome.reason), "none") << ambient_c << " x" << share << " " << requested_a;
      }
    }
  }
}

}  // namespace
}  // namespace hedgehog::safety
