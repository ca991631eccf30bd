// SPDX-License-Identifier: MIT
// Persistent state: identity of the ball, its temperatures and their time, the latch, whether the
// last stop was orderly, and the owner's gain. One small JSON file in the state directory.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "daemon/control/state/rearm_backoff.h"
#include "daemon/control/state/state.h"
#include "daemon/server/disk/boot_clock.h"
#include "model/thermal/thermal_model.h"

namespace hedgehog::server {

/// Identity of the ball of a state.
struct BallIdentity {
  bool simulated = false;
  /// Serial number of its board; empty: unknown.
  std::string serial;

  friend bool operator==(const BallIdentity&, const BallIdentity&) = default;
};

/// R25 of a winding over restarts.
struct R25History {
  /// From the last run that measured it, ohm; 0: never.
  double ohm = 0.0;
  /// Number of runs that measured it.
  int runs = 0;

  friend bool operator==(const R25History&, const R25History&) = default;
};

struct SavedState {
  /// nullopt: in files from before 1.0.
  std::optional<BallIdentity> ball;
  /// Time of `heat` and `ambient_c`.
  BootTime saved_at;
  model::ThermalState heat;
  double ambient_c = 25.0;
  /// `heat` and `ambient_c` were estimated for a ball, not the defaults above.
  bool heat_known = false;
  /// Windings whose temperature is based on their own measurement, directly or by restoring one.
  std::array<bool, model::kCoils> measured{};
  std::array<R25History, model::kCoils> r25{};
  control::Reason latch = control::Reason::kNone;
  control::RearmCounts rearms{};
  /// The daemon ended by SIGTERM without a latch.
  bool clean_stop = false;
  std::optional<double> gain;
};

std::string encode(const SavedState& state);
/// nullopt: not a state, or a value out of range.
std::optional<SavedState> decode_saved_state(std::string_view json);

/// State after a damaged one or one of another ball: a trip of that ball is unknown, so this one
/// counts as tripped, and its temperatures are unknown.
SavedState lost_state();

/// True if the two cannot be the same ball.
bool are_different(const BallIdentity& a, const BallIdentity& b) noexcept;

}  // namespace hedgehog::server
