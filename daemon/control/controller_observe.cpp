// SPDX-License-Identifier: MIT
// Thermal estimation of the controller, and selection of its measurements.
#include <algorithm>
#include <limits>

#include "daemon/control/controller.h"
#include "model/thermal/thermal_flow.h"

namespace hedgehog::control {
namespace {

constexpr double kThermistorK = 1.0;

}  // namespace

void Controller::apply_board_limits() noexcept {
  limits_ = limits_within(settings_.limits, board_);
  limiter_.set_limits(limits_);
}

void Controller::start_observer(double sensor_c) noexcept {
  model::ThermalStart start;
  start.nodes.winding_c.fill(sensor_c);
  start.nodes.core_c = sensor_c;
  start.known = settings_.start_known;
  if (settings_.start_known) {
    // The excess of the thermistor over the saved state is known for no node.
    constexpr double kPerKelvin = 0.5;
    double raised_k = std::max(0.0, sensor_c - settings_.start.core_c);
    for (std::size_t i = 0; i < model::kCoils; ++i) {
      start.nodes.winding_c[i] = std::max(settings_.start.winding_c[i], sensor_c);
      raised_k = std::max(raised_k, start.nodes.winding_c[i] - settings_.start.winding_c[i]);
    }
    start.nodes.core_c = std::max(settings_.start.core_c, sensor_c);
    start.deviation_k =
        settings_.start_deviation_k + kPerKelvin * std::max(0.0, raised_k - kThermistorK);
    start.ambient_c = settings_.start_ambient_c;
    start.measured = settings_.start_measured;
  }
  observer_ =
      model::ThermalObserver(settings_.coils, settings_.thermal, start, settings_.uncertainty);
  if (start.at_rest()) watchdog_.start_rested();
  observing_ = true;
}

void Controller::on_ball_replaced() noexcept {
  if (states_.armed()) record_trip(Reason::kStateLost);
  states_.trip_state_lost(now_);
  settings_.start_known = false;
  estimate_ = EstimateCheck();
  rejected_ = RejectedMeasurements();
  reporter_.clear_measurements();
  watchdog_.reset_windings(settings_.coils, settings_.thermal);
  observing_ = false;
}

double Controller::sensor_c() const noexcept {
  return thermistor_on(board_, settings_.thermal.sensor_winding).celsius;
}

bool Controller::is_measured(int coil) const noexcept {
  return pair_.fresh() && pair_.measured()[static_cast<std::size_t>(coil)];
}

model::Vec3 Controller::present_a() const noexcept {
  model::Vec3 a;
  for (int coil = 0; coil < model::kCoils; ++coil)
    a[coil] = is_measured(coil) ? pair_.after_a()[coil] : prediction_.a()[coil];
  return a;
}

model::ThermalMeasurement Controller::measurement() const noexcept {
  // Before this the diodes may still conduct.
  constexpr double kAsleepS = 0.1;
  model::ThermalMeasurement m;
  m.electrical_valid = pair_.electrical();
  m.voltage_v = pair_.voltage_v();
  m.supply_v = board_.supply_v;
  m.current_a = present_a();
  for (int coil = 0; coil < model::kCoils; ++coil) {
    const auto i = static_cast<std::size_t>(coil);
    const bool measured = is_measured(coil);
    m.current_before_a[coil] = measured ? pair_.before_a()[coil] : prediction_.a()[coil];
    m.current_measured[i] = measured && pair_.informative()[i];
  }
  m.idle = visibility_.asleep_s() > kAsleepS && board_.accuracy.signs;
  m.idle_a = pair_.after_a();
  m.accuracy = board_.accuracy;
  m.thermistors = watchdog_.thermistors();
  for (int coil = 0; coil < model::kCoils; ++coil) {
    const auto i = static_cast<std::size_t>(coil);
    m.thermistors.valid[i] = m.thermistors.valid[i] && watchdog_.thermistor(coil).usable();
  }
  m.fan_running = watchdog_.fan().cooling();
  return m;
}

Reason Controller::update_estimate(double dt_s) noexcept {
  const model::ThermalMeasurement m = measurement();
  const bool starts = !observing_;
  if (starts) {
    if (!watchdog_.sensor().usable()) return Reason::kNone;
    start_observer(sensor_c());
  }
  observer_.step(m, dt_s);
  rejected_.step(observer_);
  // The filter changes at the end of a window only.
  if (starts || observer_.window_ended())
    skin_.set(model::SkinInputs::of(settings_.thermal, observer_.filter(), m.fan_running));
  skin_.step(dt_s);
  const Reason found = estimate_.step(observer_, watchdog_.supply(), limits_.trip_c, dt_s);
  return states_.armed() || found == Reason::kOverheated ? found : Reason::kNone;
}

// A probe measures the present skin temperature; the estimate adds the heat still on its way there.
SkinStatus Controller::skin() const noexcept {
  const ThermometerCheck& probe = watchdog_.thermometer();
  SkinStatus status;
  status.estimate = skin_;
  status.above_k = skin_.margin_k();
  if (probe.on_shell() && !probe.known()) {
    status.above_k = std::numeric_limits<double>::infinity();
  } else if (probe.on_shell()) {
    const double by_probe_k = probe.celsius() - skin_.following_c();
    // The last reading of a thermometer that no longer delivers any may be outdated.
    status.above_k = probe.fresh() ? by_probe_k : std::max(by_probe_k, status.above_k);
  }
  status.bound_c = skin_.heated_c() + status.above_k;
  return status;
}

model::ThermalEstimate Controller::thermal() const noexcept {
  model::ThermalEstimate known = observer_.estimate();
  known.hottest_c = hottest_c();
  return known;
}

model::ThermalEstimate Controller::thermal_as_measured() const noexcept {
  model::ThermalEstimate thermal = this->thermal();
  for (int coil = 0; coil < model::kCoils; ++coil)
    if (visibility_.lost(coil)) thermal.measured[static_cast<std::size_t>(coil)] = false;
  return thermal;
}

double Controller::hottest_c() const noexcept {
  return observing_ ? observer_.estimate().hottest_c : std::numeric_limits<double>::infinity();
}

}  // namespace hedgehog::control
