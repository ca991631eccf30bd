// SPDX-License-Identifier: MIT
// Windings driven without being measured by their own V/I, so that their temperature is unknown.
#pragma once

#include <array>
#include <type_traits>

#include "daemon/control/checks/fault_debounce.h"
#include "daemon/control/checks/telemetry_pair.h"
#include "model/coils.h"

namespace hedgehog::control {

/// Control thread; real-time safe, trivially copyable.
class WindingVisibility {
 public:
  /// Counts as not measured: driven for this long without consecutive frames or a computable V/I.
  static constexpr double kBlindAfterS = 0.5;

  /// Advances by `dt_s`. `bridges_awake`: by telemetry; `driving`: by the last set-point;
  /// `predicted_a`: predicted from the set-points.
  void step(const TelemetryPair& pair, bool bridges_awake, bool driving,
            const model::Vec3& predicted_a, double dt_s) noexcept;

  /// The winding must be limited to `Limits::continuous_a`.
  bool lost(int coil) const noexcept {
    return blind_ || unmeasured_s_[static_cast<std::size_t>(coil)] > kBlindAfterS;
  }
  /// Time for which the bridges have slept.
  double asleep_s() const noexcept { return asleep_s_; }

 private:
  FaultDebounce unpaired_;
  bool blind_ = false;                                // every winding counts as not measured
  std::array<double, model::kCoils> unmeasured_s_{};  // driven time without its V/I
  model::Vec3 recent_peak_a_;
  double asleep_s_ = 0.0;
};

static_assert(std::is_trivially_copyable_v<WindingVisibility>);

}  // namespace hedgehog::control
