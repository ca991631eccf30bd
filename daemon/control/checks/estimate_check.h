// SPDX-License-Identifier: MIT
// Consistency of energy balance, V/I and thermistors, by the innovations of the observer's filter.
// A measurement outside its gate is not used; if it stays outside, the ball trips, because the
// estimate depends on one quantity fewer.
#pragma once

#include <array>

#include "daemon/control/checks/fault_debounce.h"
#include "daemon/control/checks/supply_balance.h"
#include "daemon/control/state/disagreement.h"
#include "daemon/control/state/state.h"
#include "model/estimate/thermal_observer.h"

namespace hedgehog::control {

/// Control thread; real-time safe, trivially copyable.
class EstimateCheck {
 public:
  static constexpr double kResistanceHoldS = 0.3;
  static constexpr double kThermistorHoldS = 1.0;
  static constexpr double kThermistorK = 2.0;
  static constexpr double kThermistorOffsetK = 3.5;  // beyond its tolerance
  static constexpr double kDrift = 0.02;             // R25 against its value at the cold start
  static constexpr double kFileDrift = 0.08;         // R25 against the device file
  static constexpr double kDriftHoldS = 0.5;
  /// Fall of V/I below its mean of 2 s at the same current: copper cools by 0.8 K/s at most.
  static constexpr double kFallK = 3.0;
  static constexpr double kFallHoldS = 0.1;

  static constexpr double kHotHoldS = 0.05;

  /// Advances by `dt_s`. kOverheated: the likely temperature of a winding was at `trip_c` for
  /// kHotHoldS; kMeasurementsDisagree: `disagreement()` has lasted for its hold time. `supply`
  /// identifies which of the quantities in V/I changed.
  Reason step(const model::ThermalObserver& observer, const SupplyBalance& supply, double trip_c,
              double dt_s) noexcept;
  /// The contradicting quantities of the last kMeasurementsDisagree.
  const Disagreement& disagreement() const noexcept { return disagreement_; }

  /// For a trip as overheated: a V/I or thermistor at or above `trip_c` that the filter expects
  /// below it, beyond the errors of both, and what contradicts it; none if they agree, and while
  /// temperatures are a guess. A wrong reading trips before the hold times above have passed.
  Disagreement contradicting_heat(const model::ThermalObserver& observer,
                                  const SupplyBalance& supply, double trip_c) const noexcept;

 private:
  struct Winding {
    FaultDebounce gate, drift, thermistor, fall;
    bool known = false;  // the cold-start resistance is known
    double resistance = 0.0;
    bool steady = false;
    double steady_s = 0.0;
    double steady_a = 0.0;
    double smooth_c = 25.0;
    double mean_c = 25.0;
  };

  /// Share by which V/I has changed without a change of temperature; 0 if it has not.
  struct Move {
    double share = 0.0;
    SupplyBalance::Since since = SupplyBalance::Since::kStart;
  };
  Move detect_fall(Winding& winding, const model::WindingThermometer& thermometer,
                   double dt_s) noexcept;
  Move moved(Winding& winding, const model::ThermalObserver& observer, int coil,
             double dt_s) noexcept;
  bool thermistor_off(Winding& winding, const model::ThermalObserver& observer, int coil,
                      double dt_s) noexcept;

  Disagreement check(const model::ThermalObserver& observer, const SupplyBalance& supply,
                     double dt_s) noexcept;

  std::array<Winding, model::kCoils> windings_{};
  FaultDebounce hot_;
  Disagreement disagreement_;
  double unchecked_s_ = 0.0;
};

}  // namespace hedgehog::control
