// SPDX-License-Identifier: MIT
// A device file whose resistances are not those of the ball: each winding's temperature is told
// from them, so a wrong one must not let a winding burn before somebody has calibrated it.
#include "tests/safety/safe.h"

namespace hedgehog::safety {
namespace {

using control::Reason;

struct Outcome {
  double hottest_c = 0.0;
  double seconds = 0.0;
  Reason reason = Reason::kNone;
};

/// Holds `asked_a` in `winding`, which has `share` of the resistance that the file says.
Outcome held(int winding, double share, double asked_a, int most_s, double room_c = 25.0) {
  rig::RigOptions options;
  options.board.plant.r25_ohm[static_cast<std::size_t>(winding)] *= share;
  options.board.ambient_c = options.board.start_c = room_c;
  options.control.start.winding_c.fill(room_c);
  options.control.start.core_c = options.control.start_room_c = room_c;
  rig::Rig rig(options);
  rig.run_until_armed();
  model::Vec3 along{};
  along[winding] = 1.0;
  const auto effect = rig.start(rig::hold(along, asked_a));
  Outcome outcome;
  while (outcome.seconds < most_s && rig.controller().state() == control::State::kArmed) {
    rig.update(effect, rig::hold(along, asked_a));
    rig.run(500);
    outcome.seconds += 0.5;
    outcome.hottest_c = std::max(outcome.hottest_c, rig.plant().hottest_winding_c());
  }
  outcome.reason = rig.controller().reason();
  return outcome;
}

// Winding 0 carries the thermistor, which contradicts by itself.
TEST(WrongFile, TooLittleResistanceStopsTheBallBeforeItIsWarm) {
  for (const int winding : {0, 1, 2}) {
    for (const double share : {0.5, 0.7, 0.8, 0.9}) {
      for (const double asked_a : {3.0, 5.0, 8.0, 12.0}) {
        const Outcome outcome = held(winding, share, asked_a, 10);
        EXPECT_NE(outcome.reason, Reason::kNone) << winding << " x" << share << " " << asked_a;
        EXPECT_LT(outcome.seconds, 1.6) << winding << " x" << share << " " << asked_a;
        EXPECT_LT(outcome.hottest_c, 30.0) << winding << " x" << share << " " << asked_a;
        if (winding != 0) {
          EXPECT_EQ(name(outcome.reason), "current_mismatch") << share << " " << asked_a;
        }
      }
    }
  }
}

TEST(WrongFile, TooMuchResistanceLooksLikeHeat) {
  for (const double share : {1.2, 2.0}) {
    for (const double asked_a : {5.0, 15.0}) {
      EXPECT_LT(held(1, share, asked_a, 10).seconds, 1.1) << share << " " << asked_a;
    }
  }
}

// What no check sees is bounded: 1 % is 2.5 K (DESIGN section 6).
TEST(WrongFile, FivePercentIsTwelveKelvin) {
  const Outcome outcome = held(1, 0.95, 12.0, 120);
  EXPECT_EQ(name(outcome.reason), "none");
  EXPECT_LT(outcome.hottest_c, 69.0 + 14.0);
}

TEST(WrongFile, ARightOneAndAColdRoomAreNoFault) {
  for (const double room_c : {5.0, 25.0}) {
    for (const double share : {0.97, 1.0, 1.03}) {
      for (const double asked_a : {1.6, 5.0, 15.0}) {
        const Outcome outcome = held(1, share, asked_a, 20, room_c);
        EXPECT_EQ(name(outcome.reason), "none") << room_c << " x" << share << " " << asked_a;
      }
    }
  }
}

}  // namespace
}  // namespace hedgehog::safety
