// SPDX-License-Identifier: MIT
// What our set-points make flow in the windings until telemetry shows it, which is two ticks later
// and more on a real wire: the voltage of the next set-point cannot wait for it.
#pragma once

#include <array>
#include <type_traits>

#include "daemon/device/board_io.h"
#include "model/coils.h"
#include "model/tick.h"

namespace hedgehog::control {

/// The link makes the board safe after so many ticks without a set-point, so no more than that was
/// heated in a gap.
inline constexpr model::Tick kLongestGap = 20;

/// The windings as a set-point finds them: each a resistance and an inductance on one supply.
struct WindingCircuit {
  /// As estimated, ohm.
  std::array<double, model::kCoils> resistance_ohm{};
  /// Of each, henry.
  double inductance_h = 0.0;
  /// As measured, volt.
  double supply_v = 0.0;
};

/// Control thread; real-time safe, trivially copyable.
class CurrentPrediction {
 public:
  /// One tick with the new set-point `command`, boost included.
  void predict_currents(const device::BoardCommand& command,
                        const WindingCircuit& circuit) noexcept;
  /// `skipped` ticks without a new one: the board holds `command`, until the link makes it safe.
  void advance_skipped_ticks(model::Tick skipped, const device::BoardCommand& command,
                             const WindingCircuit& circuit) noexcept;

  /// What flows at the end of it, A.
  const model::Vec3& a() const noexcept { return a_; }

 private:
  void advance(const model::Vec3& voltage, model::Tick ticks,
               const WindingCircuit& circuit) noexcept;

  model::Vec3 a_;
};

static_assert(std::is_trivially_copyable_v<CurrentPrediction>);

}  // namespace hedgehog::control
