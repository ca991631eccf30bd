// SPDX-License-Identifier: MIT
// Winding currents predicted from the set-points until telemetry contains them, two ticks later or
// more on a real bus: the voltage of the next set-point cannot wait for it.
#pragma once

#include <array>
#include <type_traits>

#include "daemon/device/board_io.h"
#include "model/coils.h"
#include "model/tick.h"

namespace hedgehog::control {

/// The link sends the safe command after this many ticks without a set-point, so a gap heats for no
/// longer.
inline constexpr model::Tick kLongestGap = 20;

/// Minimum voltage that opposes the current of a winding whose bridge sleeps: that of a diode. The
/// supply adds to it in most bridges, which ends the current sooner.
inline constexpr double kFreewheelV = 0.8;

/// Electrical model of the windings: each a resistance and an inductance on one supply.
struct WindingCircuit {
  /// Estimated, ohm.
  std::array<double, model::kCoils> resistance_ohm{};
  /// Of each winding, henry.
  double inductance_h = 0.0;
  /// Measured, V.
  double supply_v = 0.0;
};

/// Control thread; real-time safe, trivially copyable.
class CurrentPrediction {
 public:
  /// Advances by one tick with the new set-point `command`, boost included.
  void predict_currents(const device::BoardCommand& command,
                        const WindingCircuit& circuit) noexcept;
  /// Advances by `skipped` ticks without a new set-point: the board holds `command` until the link
  /// sends the safe one.
  void advance_skipped_ticks(model::Tick skipped, const device::BoardCommand& command,
                             const WindingCircuit& circuit) noexcept;

  /// Currents at the end of the tick, A.
  const model::Vec3& a() const noexcept { return a_; }

 private:
  void drive(const model::Vec3& voltage, model::Tick ticks, const WindingCircuit& circuit) noexcept;
  void sleep(model::Tick ticks, const WindingCircuit& circuit) noexcept;

  model::Vec3 a_;
};

static_assert(std::is_trivially_copyable_v<CurrentPrediction>);

}  // namespace hedgehog::control
