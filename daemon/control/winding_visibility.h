// SPDX-License-Identifier: MIT
// Which windings are not measured by their own V/I although they are driven, so that nobody knows
// how warm they get.
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
  /// Driven for so long without two frames in a row, or with readings that do not show it, a
  /// winding counts as not measured.
  static constexpr double kBlindAfterS = 0.5;

  /// `dt_s` later: the tick's telemetry, the bridges as it shows them, whether the last set-point
  /// drove, and the currents that our set-points make flow, A.
  void step(const TelemetryPair& pair, bool bridges_awake, bool driving,
            const model::Vec3& predicted_a, double dt_s) noexcept;

  /// To be held to `Limits::continuous_a`.
  bool lost(int coil) const noexcept {
    return blind_ || unmeasured_s_[static_cast<std::size_t>(coil)] > kBlindAfterS;
  }
  /// For how long the bridges have been asleep.
  double asleep_s() const noexcept { return asleep_s_; }

 private:
  FaultDebounce unpaired_;
  bool blind_ = false;  // each winding is lost
  /// Of each winding: for how long it has been driven without its V/I.
  std::array<double, model::kCoils> unmeasured_s_{};
  model::Vec3 recent_peak_a_;
  double asleep_s_ = 0.0;
};

static_assert(std::is_trivially_copyable_v<WindingVisibility>);

}  // namespace hedgehog::control
