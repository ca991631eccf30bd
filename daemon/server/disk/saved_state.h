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

/// Which ball a state is of.
struct BallIdentity {
  bool simulated = false;
  /// Of its board; empty: unknown.
  std::string serial;

  friend bool operator==(const BallIdentity&, const BallIdentity&) = default;
};

/// R25 of a winding over the restarts.
struct R25History {
  /// As of the last run that measured it, ohm; 0: none has.
  double ohm = 0.0;
  /// So many runs have.
  int runs = 0;

  friend bool operator==(const R25History&, const R25History&) = default;
};

struct SavedState {
  /// nullopt: in files of before 1.0.
  std::optional<BallIdentity> ball;
  /// When `heat` and `ambient_c` were so.
  BootTime saved_at;
  model::ThermalState heat;
  double ambient_c = 25.0;
  /// `heat` and `ambient_c` are of a ball, not the values above.
  bool heat_known = false;
  /// Which windings had measured themselves, or came from such a measurement.
  std::array<bool, model::kCoils> measured{};
  std::array<R25History, model::kCoils> r25{};
  control::Reason latch = control::Reason::kNone;
  control::RearmCounts rearms{};
  /// The daemon ended by SIGTERM without a latch.
  bool clean_stop = false;
  std::optional<double> gain;
};

std::string encode(const SavedState& state);
/// nullopt: not ours, or a value that cannot be.
std::optional<SavedState> decode_saved_state(std::string_view json);

/// What is left when a state is damaged or of another ball: whether that ball had tripped is not
/// known, so this one has, and nothing is known of its heat.
SavedState lost_state();

/// The two cannot be the same ball.
bool are_different(const BallIdentity& a, const BallIdentity& b) noexcept;

}  // namespace hedgehog::server
