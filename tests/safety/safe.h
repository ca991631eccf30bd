// SPDX-License-Identifier: MIT
// What "safe" and "zero" mean, as assertions (daemon/safety.md).
#pragma once

#include <gtest/gtest.h>

#include "tests/rig/rig.h"

namespace hedgehog::safety {

/// 5 L/R of a winding at 25 C, ticks.
inline constexpr model::Tick kDecay = 17;
inline constexpr double kZeroA = 0.1;

/// Disables the limiter: only the watchdog and the board protect the ball.
inline rig::RigOptions without_limiter(double trip_c = 70.0) {
  rig::RigOptions options;
  model::Limits& limits = options.control.limits;
  limits.derate_from_c = 300.0;
  limits.sustain_c = 310.0;
  limits.zero_c = 320.0;
  limits.trip_c = trip_c;
  options.control.ceiling = limits;
  return options;
}

/// Armed, with 5 A along x for 100 ms.
inline void hold_five_ampere(rig::Rig& rig) {
  rig.run_until_armed();
  rig.start(rig::hold({1, 0, 0}, 5.0));
  rig.run(100);
}

/// True if the bridges of the simulated board sleep and their duty is 0, on the board's side of the
/// wire.
inline bool asleep(rig::Rig& rig) {
  const board::BoardOutputs& out = rig.board().core().outputs();
  return !out.awake && out.duty_q15[0] == 0 && out.duty_q15[1] == 0 && out.duty_q15[2] == 0;
}

/// The safe command reaches the bridge within `within` ticks from now, and then |I| < 0.1 A at the
/// plant after 5 L/R.
inline void expect_zero(rig::Rig& rig, model::Tick within) {
  const model::Tick from = rig.now();
  EXPECT_TRUE(rig.run_until([&] { return asleep(rig); }, within)) << "not safe in time";
  ::testing::Test::RecordProperty("safe_after_ticks", static_cast<int>(rig.now() - from));
  rig.run(kDecay);
  EXPECT_LT(rig.current_a(), kZeroA);
}

/// Tripped for `reason`, which is latched and reported in one event.
inline void expect_tripped(const rig::Rig& rig, control::Reason reason) {
  const control::StatusSnapshot status = rig.snapshot();
  EXPECT_EQ(name(status.state), name(control::State::kTripped));
  EXPECT_EQ(name(status.reason), name(reason));
  EXPECT_EQ(name(status.latch), name(reason));
  EXPECT_EQ(name(status.last_trip.reason), name(reason));
  EXPECT_EQ(rig.last_command().fan, 255);
  int events = 0;
  for (const control::Event& event : rig.events()) {
    if (event.type == control::EventType::kStateChanged &&
        event.state == control::State::kTripped) {
      ++events;
      EXPECT_EQ(name(event.reason), name(reason));
    }
  }
  EXPECT_EQ(events, 1) << "one event an episode";
}

}  // namespace hedgehog::safety
