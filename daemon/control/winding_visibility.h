// SPDX-License-Identifier: MIT
// Windings that are driven without being measured by their own V/I, so that their temperature is
// unknown.
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
  /// A winding that has been driven for this long without two consecutive frames, or with readings
  /// from which V/I cannot be computed, counts as not measured.
  static constexpr double kBlindAfterS = 0.5;

  /// Advances by `dt_s`: the tick's telemetry, the bridge state it contains, whether the last
  /// set-point drove, and the currents predicted from the set-points, A.
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
  bool blind_ = false;  // every winding counts as not measured
  /// Per winding: driven time without its V/I, s.
  std::array<double, model::kCoils> unmeasured_s_{};
  model::Vec3 recent_peak_a_;
  double asleep_s_ = 0.0;
};

static_assert(std::is_trivially_copyable_v<WindingVisibility>);

}  // namespace hedgehog::control
