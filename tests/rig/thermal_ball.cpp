// SPDX-License-Identifier: MIT
#include "tests/rig/thermal_ball.h"

#include <algorithm>
#include <cmath>

#include "model/limit/shell_limit.h"

namespace hedgehog::rig {
namespace {

using control::Quantity;
using control::Reason;
using model::kCoils;
using model::Vec3;

// A step's readings are the mean of 20 conversions.
const double kAveraged = std::sqrt(20.0);
constexpr double kConversionK = 0.05;

model::ThermalStart start_of(const ThermalBallOptions& options, double shown_c) noexcept {
  model::ThermalStart start;
  start.nodes = {{shown_c, shown_c, shown_c}, shown_c};
  start.known = options.known;
  start.measured.fill(options.known);
  return start;
}

double rounded(double value, double step) noexcept { return std::round(value / step) * step; }

}  // namespace

ThermalBall::ThermalBall(const ThermalBallOptions& options) noexcept
    : coils_(options.coils),
      thermal_(options.thermal),
      plant_(options.board.plant, options.board.ambient_c),
      built_(options.board.front_end.parameters()),
      random_(options.seed),
      skin_limits_(options.skin_limits),
      heat_(coils_, thermal_) {
  plant_.set_heat({{options.board.start_c, options.board.start_c, options.board.start_c},
                   options.board.start_c});
  const bool in_line = built_.kind == device::FrontEndKind::kInLine;
  accuracy_ = in_line ? model::kInLineAccuracy : model::kDriverCsAccuracy;
  const double shown_c = read_thermistors().celsius[0];
  observer_ =
      model::ThermalObserver(coils_, thermal_, start_of(options, shown_c), options.uncertainty);
  if (options.known) heat_.start_rested();
  skin_.step(model::SkinInputs::of(thermal_, observer_.filter(), false), kStepS);
}

model::ThermistorReadings ThermalBall::read_thermistors() noexcept {
  const device::FrontEndParameters now = errors_.on(built_);
  model::ThermistorReadings readings;
  for (int coil = 0; coil < kCoils; ++coil) {
    const auto i = static_cast<std::size_t>(coil);
    readings.valid[i] = now.wiring.thermistors > 1 || coil == thermal_.sensor_winding;
    const double shown = plant_.thermistor_c(coil) + now.thermistor_offset_k[i] +
                         plant_.parameters().sensor_noise_k * random_.gaussian();
    readings.celsius[i] = rounded(shown, kConversionK);
  }
  return readings;
}

void ThermalBall::step(const Vec3& peak_a, double rms) noexcept {
  bool changed = false;
  for (int ms = 0; ms < 20; ++ms) changed |= errors_.step();
  if (changed) plant_.set_errors(errors_.plant());
  const device::FrontEndParameters now = errors_.on(built_);

  if (skin_limits_)
    limiter_.set_ceiling(model::shell_allowed_current(model::Limits{}, skin_.celsius()));
  Vec3 passed = limiter_.limit({peak_a}, observer_.estimate(), kStepS).a();
  if (stop_.any()) passed = {};
  reduced_ = norm(passed) < 0.995 * std::min(norm(peak_a), model::Limits{}.current_a);
  const double drawn_before_a = model::dot(current_a_, current_a_) * 0.5 / 12.0;
  const double supply_v = plant_.parameters().supply_v - now.source_ohm * drawn_before_a;
  const double supply_read_v =
      now.supply_gain * supply_v + now.supply_noise_v / kAveraged * random_.gaussian();

  model::ThermalMeasurement m;
  Vec3 duty;
  Vec3 squares;
  double drawn_a = 0.0;
  bool any = false;
  for (int coil = 0; coil < kCoils; ++coil) {
    const auto i = static_cast<std::size_t>(coil);
    const double requested_a = rms * passed[coil];
    duty[coil] = observer_.estimate().resistance_ohm[i] * requested_a / supply_read_v;
    current_a_[coil] = duty[coil] * supply_v / plant_.resistance_ohm(coil);
    squares[coil] = current_a_[coil] * current_a_[coil];
    drawn_a += duty[coil] * current_a_[coil];
    const double sign = current_a_[coil] < 0.0 && !accuracy_.signs ? -1.0 : 1.0;
    const double disturbed_a =
        sign * now.current_offset_a[i] + now.current_noise_a / kAveraged * random_.gaussian();
    const double shown_a = rounded(now.current_gain[i] * current_a_[coil] + disturbed_a, 1e-3);
    m.current_a[coil] = shown_a;
    m.voltage_v[coil] = duty[coil] * supply_read_v;
    any |= requested_a != 0.0;
  }
  m.supply_v = supply_read_v;
  m.electrical_valid = any;
  m.idle = !any && accuracy_.signs;
  m.idle_a = m.current_a;
  if (!any) m.current_a = {};
  for (std::size_t i = 0; i < kCoils; ++i)
    m.current_measured[i] = accuracy_.signs || duty[static_cast<int>(i)] != 0.0;
  if (!accuracy_.signs) {
    for (int coil = 0; coil < kCoils; ++coil)
      if (duty[coil] == 0.0) m.current_a[coil] = 0.0;
  }
  m.current_before_a = m.current_a;
  m.accuracy = accuracy_;
  plant_.step_thermal(squares, fan_duty_, kStepS);
  m.thermistors = read_thermistors();
  const double rpm = errors_.tach_gain() * plant_.fan_rpm();
  fan_check_.follow({true, fan_duty_, rpm}, kStepS);
  m.fan_running = fan_check_.cooling();
  const double supply_a = now.shunt_gain * drawn_a + now.shunt_offset_a +
                          now.shunt_noise_a / kAveraged * random_.gaussian();
  run_checks(m, duty, supply_a, supply_read_v, fan_check_.step(fan_duty_ > 0.0, rpm, kStepS));
}

Reason ThermalBall::check_thermistor(const model::ThermalMeasurement& m, int coil) noexcept {
  const auto i = static_cast<std::size_t>(coil);
  control::SensorReading reading;
  reading.fresh = true;
  reading.sensor_c = m.thermistors.celsius[i];
  reading.conversions = conversions_;
  reading.measuring = heat_.measuring(coil) && heat_.referenced(coil);
  reading.winding_c = heat_.winding_c(coil);
  if (reading.measuring) {
    reading.winding_bias_k = heat_.bias_k(coil);
    reading.winding_error_k = heat_.noise_k(coil) + reading.winding_bias_k;
  }
  reading.since_s = kStepS;
  return thermistor_checks_[i].step(reading, kStepS);
}

Stop ThermalBall::check_thermistors(const model::ThermalMeasurement& m) noexcept {
  ++conversions_;
  Stop found;
  found.reason = check_thermistor(m, thermal_.sensor_winding);
  for (int coil = 0; coil < kCoils && m.thermistors.count() > 1; ++coil) {
    if (coil == thermal_.sensor_winding) continue;
    const control::Disagreement other = control::disagreement_of(coil, check_thermistor(m, coil));
    if (other.any() && !found.any()) found = {Reason::kMeasurementsDisagree, other};
  }
  return found;
}

void ThermalBall::run_checks(const model::ThermalMeasurement& m, const Vec3& duty,
                             double supply_current_a, double supply_v, Reason fan) noexcept {
  const Stop thermistor = check_thermistors(m);
  control::HeatReading heat_reading;
  heat_reading.electrical = m.electrical_valid;
  heat_reading.voltage_v = m.voltage_v;
  heat_reading.before_a = m.current_before_a;
  heat_reading.after_a = m.current_a;
  heat_reading.measured = m.current_measured;
  heat_reading.accuracy = accuracy_;
  heat_reading.thermistors = m.thermistors;
  heat_reading.since_s = kStepS;
  const Reason heat = heat_.step(heat_reading, model::Limits{}.trip_c, kStepS);

  observer_.step(m, kStepS);
  skin_.step(model::SkinInputs::of(thermal_, observer_.filter(), m.fan_running), kStepS);
  control::SupplyReading supply;
  supply.known = m.electrical_valid;
  supply.duty = duty;
  supply.current_a = m.current_a;
  supply.supply_current_a = supply_current_a;
  supply.supply_v = supply_v;
  supply.accuracy = accuracy_;
  const control::Disagreement current = supply_.step(supply, kStepS);
  const Reason estimate = estimate_.step(observer_, supply_, model::Limits{}.trip_c, kStepS);
  fan_duty_ = fan_.step(observer_.estimate().hottest_c, norm(m.current_a), kStepS) / 255.0;
  if (stop_.any()) return;
  if (thermistor.any() || heat != Reason::kNone) {
    stop_ = thermistor.any() ? thermistor : Stop{heat, {}};
  } else if (current.any()) {
    stop_ = {Reason::kMeasurementsDisagree, current};
  } else if (fan != Reason::kNone) {
    stop_ = {fan, {}};
  } else if (estimate != Reason::kNone) {
    stop_ = {estimate, estimate == Reason::kMeasurementsDisagree ? estimate_.disagreement()
                                                                 : control::Disagreement{}};
  }
  if (stop_.reason == Reason::kOverheated)
    stop_.disagreement = estimate_.contradicting_heat(observer_, supply_, model::Limits{}.trip_c);
}

std::string words(const Stop& stop) {
  std::string text(name(stop.reason));
  if (!stop.disagreement.any()) return text;
  text += std::string(" (winding ") + "xyz"[stop.disagreement.coil()] + ":";
  for (int i = 0; i < control::kQuantities; ++i) {
    const auto quantity = static_cast<Quantity>(i);
    if (stop.disagreement.has(quantity)) text += " " + std::string(name(quantity));
  }
  return text + ")";
}

ThermalBallOptions family_ball(std::uint64_t seed, const device::FrontEndChoice& front_end,
                               double tolerance) noexcept {
  model::RandomStream random(seed);
  ThermalBallOptions options;
  options.seed = random.bits();
  options.uncertainty.thermal = tolerance;
  model::PlantParameters& plant = options.board.plant;
  const auto off = [&](double& value, double by) { value *= random.uniform(1.0 - by, 1.0 + by); };
  for (double& value : plant.winding_j_k) off(value, tolerance);
  for (double& value : plant.winding_to_core_k_w) off(value, tolerance);
  off(plant.core_j_k, tolerance);
  off(plant.core_to_ambient_fan_k_w, tolerance);
  off(plant.core_to_ambient_still_k_w, tolerance);
  for (double& value : plant.r25_ohm) off(value, 0.03);
  off(plant.supply_v, 0.02);
  plant.sensor_lag_s = random.uniform(1.0, 3.0);
  plant.seed = random.bits();
  options.board.ambient_c = random.uniform(18.0, 32.0);
  options.board.start_c = options.board.ambient_c;
  options.board.front_end = front_end;
  options.board.front_end.seed = random.bits() | 1;
  return options;
}

}  // namespace hedgehog::rig
