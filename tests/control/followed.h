// SPDX-License-Identifier: MIT
// An estimate check and its observer, with simulated measurements of one winding.
#pragma once

#include "daemon/control/checks/estimate_check.h"
#include "model/coils.h"

namespace hedgehog::control {

inline constexpr int kDriven = 1;

/// A ball at rest, of which one winding carries current.
class Followed {
 public:
  explicit Followed(double celsius, bool known = true) {
    model::ThermalStart start;
    start.nodes = {{celsius, celsius, celsius}, celsius};
    start.known = known;
    observer_ = model::ThermalObserver({}, {}, start);
    measurement_.supply_v = 12.0;
    measurement_.thermistors.celsius.fill(celsius);
    measurement_.thermistors.valid.fill(true);
  }

  /// R25 by V/I, relative to the device file's.
  double r25_gain = 1.0;
  /// The supply's current and voltage are measured too.
  bool supply_known = false;
  double supply_v = 12.0;

  /// A tick in which V/I gives the resistance at `shown_c`.
  Reason tick(double current_a, double shown_c) {
    measurement_.electrical_valid = true;
    const double ohm =
        r25_gain * model::resistance_at(model::Ohms(0.45), model::Celsius(shown_c)).value;
    measurement_.current_before_a[kDriven] = measurement_.current_a[kDriven] = current_a;
    measurement_.voltage_v[kDriven] = current_a * ohm;
    observer_.step(measurement_);
    if (supply_known) step_supply();
    return check_.step(observer_, supply_, 70.0, model::kTickSeconds);
  }
  /// A tick with sleeping bridges.
  Reason sleep() {
    measurement_.electrical_valid = false;
    measurement_.current_before_a = measurement_.current_a = measurement_.voltage_v = {};
    observer_.step(measurement_);
    return check_.step(observer_, supply_, 70.0, model::kTickSeconds);
  }
  void show(int coil, double celsius) {
    measurement_.thermistors.celsius[static_cast<std::size_t>(coil)] = celsius;
  }
  void set_accuracy(const model::CurrentAccuracy& accuracy) { measurement_.accuracy = accuracy; }
  void set_thermistor(int coil, bool valid) {
    measurement_.thermistors.valid[static_cast<std::size_t>(coil)] = valid;
  }
  double winding_c() const { return observer_.filter().winding_c(kDriven); }
  const Disagreement& disagreement() const { return check_.disagreement(); }
  Disagreement contradicting_heat() const {
    return check_.contradicting_heat(observer_, supply_, 70.0);
  }

 private:
  void step_supply() {
    SupplyReading reading;
    reading.known = true;
    reading.duty = (1.0 / supply_v) * measurement_.voltage_v;
    reading.current_a = measurement_.current_a;
    reading.supply_current_a = dot(reading.duty, reading.current_a);
    reading.supply_v = supply_v;
    reading.accuracy = model::kInLineAccuracy;
    supply_.step(reading, model::kTickSeconds);
  }

  model::ThermalMeasurement measurement_;
  model::ThermalObserver observer_;
  SupplyBalance supply_;
  EstimateCheck check_;
};

/// Ticks until the check reports a fault, at most 20 s.
template <class Tick>
int ticks_until_found(const Tick& tick, Reason& found) {
  int ticks = 0;
  while ((found = tick()) == Reason::kNone && ticks < 20'000) ++ticks;
  return ticks;
}

}  // namespace hedgehog::control
