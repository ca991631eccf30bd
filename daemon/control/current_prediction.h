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

/// Longest gap without a set-point, after which the link sends the safe command.
inline constexpr model::Tick kLongestGap = 20;

/// Minimum voltage opposing the current of a winding whose bridge sleeps: that of a diode. In most
/// bridges the supply adds to it, which ends the current sooner.
inline constexpr double kFreewheelV = 0.8;

/// Electrical model of the windings: each a resistance and an inductance on one supply.
struct WindingCircuit {
  std::array<double, model::kCoils> resistance_ohm{};  // estimated
  double inductance_h = 0.0;                           // henry, of each winding
  double supply_v = 0.0;                               // measured
};

/// Control thread; real-time safe, trivially copyable.
class CurrentPrediction {
 public:
  /// Advances by one tick with the new set-point `command`, boost included.
  void predict_currents(const device::BoardCommand& command,
                        const WindingCircuit& circuit) noexcept;
  /// Advances by `skipped` ticks: the board holds `command` until the link sends the safe one.
  void advance_skipped_ticks(model::Tick skipped, const device::BoardCommand& command,
                             const WindingCircuit& circuit) noexcept;

  /// Currents at the end of the tick.
  const model::Vec3& a() const noexcept { return a_; }

 private:
  void drive(const model::Vec3& voltage, model::Tick ticks, const WindingCircuit& circuit) noexcept;
  void sleep(model::Tick ticks, const WindingCircuit& circuit) noexcept;

  model::Vec3 a_;
};

static_assert(std::is_trivially_copyable_v<CurrentPrediction>);

}  // namespace hedgehog::control
