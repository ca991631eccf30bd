// SPDX-License-Identifier: MIT
// What a restart must not forget: how hot the ball was and when, what had latched, whether the last
// stop was orderly, and the owner's gain. One small JSON file in the state directory.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "daemon/control/state.h"
#include "model/thermal_model.h"

namespace hedgehog::server {

struct SavedState {
  /// Seconds since 1970 when this was true.
  double wall_time_s = 0.0;
  model::ThermalState heat;
  double room_c = 25.0;
  /// `heat` and `room_c` are of a ball, not the values above.
  bool heat_known = false;
  /// Which windings had measured themselves, or came from such a measurement.
  std::array<bool, model::kCoils> measured{};
  control::Reason latch = control::Reason::kNone;
  /// The daemon ended by SIGTERM without a latch.
  bool clean_stop = false;
  std::optional<double> gain;
};

std::string encode(const SavedState& state);
/// nullopt: not ours, or a value that cannot be.
std::optional<SavedState> decode_saved_state(std::string_view json);

/// The heat `seconds` later, coils off and fan standing. Negative seconds (the clock was set back)
/// count as none.
model::ThermalState decayed(const model::ThermalModel& model, model::ThermalState heat,
                            double room_c, double seconds) noexcept;

}  // namespace hedgehog::server
