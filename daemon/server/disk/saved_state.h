// SPDX-License-Identifier: MIT
// Persistent state: one small JSON file in the state directory.
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

struct BallIdentity {
  bool simulated = false;
  std::string serial;  // of its board; empty: unknown

  friend bool operator==(const BallIdentity&, const BallIdentity&) = default;
};

/// R25 of a winding over restarts.
struct R25History {
  double ohm = 0.0;  // from the last run that measured it; 0: never
  int runs = 0;      // number of runs that measured it

  friend bool operator==(const R25History&, const R25History&) = default;
};

struct SavedState {
  std::optional<BallIdentity> ball;  // nullopt: in files from before 1.0
  BootTime saved_at;                 // time of heat and ambient_c
  model::ThermalState heat;
  double ambient_c = 25.0;
  bool heat_known = false;  // heat and ambient_c are estimates, not the defaults
  /// Windings whose temperature is based on their own measurement, directly or by restoring one.
  std::array<bool, model::kCoils> measured{};
  std::array<R25History, model::kCoils> r25{};
  control::Reason latch = control::Reason::kNone;
  control::RearmCounts rearms{};
  bool clean_stop = false;  // ended by SIGTERM without a latch
  std::optional<double> gain;
};

std::string encode(const SavedState& state);
/// nullopt: not a state, or a value out of range.
std::optional<SavedState> decode_saved_state(std::string_view json);

/// In place of a damaged state or one of another ball: tripped, with unknown temperatures.
SavedState lost_state();

/// True if the two cannot be the same ball.
bool are_different(const BallIdentity& a, const BallIdentity& b) noexcept;

}  // namespace hedgehog::server
