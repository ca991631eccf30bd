// SPDX-License-Identifier: MIT
#include "model/estimate/thermal_observer.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "model/estimate/supply_line.h"

namespace hedgehog::model {
namespace {

constexpr double kMaxPlausibleA = 100.0;
constexpr double kWarmAmbientC = 35.0;

// Standard deviations from the estimate to the bound, and margins of the floors.
constexpr double kBoundDeviations = 2.5;
constexpr double kLikelyDeviationsK = 1.5;
constexpr double kFloorMarginK = 1.0;
constexpr double kThermistorMarginK = 0.5;
// Fixed margins for faults that poorer electronics detect late: one thermistor for three windings;
// and unsigned currents, accurate to 0.1 A.
constexpr double kSingleThermistorMarginK = 0.5;
constexpr double kUnsignedCurrentMarginK = 3.0;

// Maximum excess of the lead over the filter's estimate of its winding.
constexpr double kMaxLeadK = 4.0;

// After a start from unknown temperatures the filter's bound is capped for kSettlingS at a value
// that still allows 5 A, so that V/I can be measured.
constexpr double kSettlingS = 20.0;
constexpr double kProbingC = 66.9;
constexpr double kUnknownK = 20.0;

// Error of V/I besides noise and offset: the relative error of the meter.
constexpr double kMeterShare = 0.0015;
constexpr double kMeterNoiseA = 0.02;
// A current that has changed by less than this share since the previous window counts as steady.
constexpr double kSteadyShare = 0.1;

constexpr double kSupplySmoothS = 0.3;

// Limit of V/I against the filter's resistance, where it enters a loss or a drive voltage.
constexpr double kMaxResistanceRatio = 2.0;

bool believable(const Vec3& v, double most) noexcept { return is_finite(v) && norm(v) <= most; }

double coolest(const ThermalState& nodes) noexcept {
  const auto& w = nodes.winding_c;
  return std::min({w[0], w[1], w[2], nodes.core_c});
}

FilterStart filter_start(const ThermalStart& start, double ambient_c) noexcept {
  FilterStart f;
  f.nodes = start.nodes;
  f.ambient_c = ambient_c;
  if (start.known) {
    f.single_k = start.deviation_k;
  } else {
    f.common_k = 0.0;
    f.single_k = kUnknownK;
  }
  return f;
}

}  // namespace

ThermalObserver::ThermalObserver(const CoilModel& coils, const ThermalModel& thermal,
                                 const ThermalStart& start,
                                 const ThermalUncertainty& uncertainty) noexcept
    : coils_(coils), thermal_(thermal), settling_s_(start.known ? 0.0 : kSettlingS) {
  const double coolest_c = coolest(start.nodes);
  const double guess_c = coolest_c < kWarmAmbientC ? coolest_c : 25.0;
  const double ambient_c = std::isfinite(start.ambient_c) ? start.ambient_c : guess_c;
  filter_ = ThermalFilter(coils, thermal, uncertainty, filter_start(start, ambient_c));
  floor_ = EnergyFloor(thermal, uncertainty.thermal, start.nodes, ambient_c);
  for (std::size_t i = 0; i < kCoils; ++i) {
    thermometer_[i] = WindingThermometer(coils, thermal, static_cast<int>(i));
    fall_[i] = ResistanceFall(coils.r25_ohm[i], uncertainty.resistance);
    if (start.at_rest()) thermometer_[i].start_rested();
  }
  const double at = start.nodes.winding_c[static_cast<std::size_t>(thermal.sensor_winding)];
  sensor_ = ThermistorLead(at);
  estimate_.sensor_lead_c = at;
  estimate_.measured = start.measured;
  take_from_filter();
  bound();
}

void ThermalObserver::step(const ThermalMeasurement& m, double dt_s) noexcept {
  settling_s_ = std::max(0.0, settling_s_ - dt_s);
  if (m.accuracy != accuracy_) {
    accuracy_ = m.accuracy;
    filter_.set_current_accuracy(accuracy_);
    for (WindingThermometer& one : thermometer_) one.set_accuracy(accuracy_);
  }
  follow_thermistors(m.thermistors, dt_s);
  follow_supply(m, dt_s);
  follow_currents(m, dt_s);
  window_.s += dt_s;
  ++window_.ticks;
  constexpr double kWindowRoundingS = 1e-9;
  window_ended_ = window_.s >= kWindowS - kWindowRoundingS;
  if (window_ended_) end_window(m.fan_running);
  bound();
}

void ThermalObserver::follow_currents(const ThermalMeasurement& m, double dt_s) noexcept {
  const bool known =
      believable(m.current_a, kMaxPlausibleA) && believable(m.current_before_a, kMaxPlausibleA);
  const bool electrical = m.electrical_valid && known && is_finite(m.voltage_v);
  bool rested = true;
  for (const WindingThermometer& one : thermometer_) rested = rested && one.rested();
  for (int coil = 0; coil < kCoils; ++coil) {
    const auto i = static_cast<std::size_t>(coil);
    const double from = m.current_before_a[coil];
    const double to = m.current_a[coil];
    if (known) mean_square_a2_[coil] = (from * from + from * to + to * to) / 3.0;
    WindingThermometer& thermometer = thermometer_[i];
    const double ohm = resistance_ohm(coil);
    WindingReading reading;
    reading.voltage_v = m.voltage_v[coil];
    reading.before_a = from;
    reading.after_a = to;
    reading.measured = electrical && m.current_measured[i];
    reading.loss_w = ohm * mean_square_a2_[coil];
    reading.reference = reference_of(thermistors_, coil, thermal_.sensor_winding, rested);
    thermometer.step(reading, dt_s);
    fall_[i].follow(thermometer, accuracy_.offset_a);
    window_.heat_j[i] += reading.loss_w * dt_s;
    if (!thermometer.measuring()) window_.always_measured[i] = false;
    if (m.idle && std::isfinite(m.idle_a[coil])) {
      ++window_.idle_ticks[i];
      window_.idle_a_sum[coil] += m.idle_a[coil];
    }
    estimate_.measuring[i] = thermometer.measuring();
    if (thermometer.measuring()) estimate_.measured[i] = true;
    estimate_.resistance_ohm[i] = ohm;
  }
}

double ThermalObserver::resistance_ohm(int coil) const noexcept {
  const WindingThermometer& thermometer = thermometer_[static_cast<std::size_t>(coil)];
  const double expected = expected_ohm_[static_cast<std::size_t>(coil)];
  if (!thermometer.measuring()) return expected;
  return std::clamp(thermometer.meter().resistance_ohm(), expected / kMaxResistanceRatio,
                    expected * kMaxResistanceRatio);
}

void ThermalObserver::follow_thermistors(const ThermistorReadings& thermistors,
                                         double dt_s) noexcept {
  thermistors_ = thermistors;
  for (std::size_t i = 0; i < kCoils; ++i) {
    bool& valid = thermistors_.valid[i];
    valid = valid && std::isfinite(thermistors.celsius[i]);
    if (!valid) continue;
    ++window_.thermistor_ticks[i];
    window_.thermistor_sum[i] += thermistors.celsius[i];
  }
  const auto own = static_cast<std::size_t>(thermal_.sensor_winding);
  sensor_.step(thermistors_.valid[own], thermistors_.celsius[own], dt_s);
  estimate_.sensor_lead_c = sensor_.celsius();
}

void ThermalObserver::end_window(bool fan_running) noexcept {
  std::array<double, kCoils> loss_w{};
  for (std::size_t i = 0; i < kCoils; ++i) loss_w[i] = window_.heat_j[i] / window_.s;
  filter_.predict(loss_w, fan_running, window_.s);
  ThermistorReadings mean;
  for (std::size_t i = 0; i < kCoils; ++i) {
    mean.valid[i] = window_.thermistor_ticks[i] > 0;
    if (mean.valid[i]) mean.celsius[i] = window_.thermistor_sum[i] / window_.thermistor_ticks[i];
  }
  floor_.step(loss_w, fan_running, mean, window_.s);
  for (int coil = 0; coil < kCoils; ++coil) {
    correct_winding(coil);
    const auto i = static_cast<std::size_t>(coil);
    innovations_[i].thermistor_known = mean.valid[i];
    if (mean.valid[i]) innovations_[i].thermistor = filter_.thermistor(coil, mean.celsius[i]);
  }
  for (std::size_t i = 0; i < kCoils; ++i) {
    fall_[i].age(window_.s);
    if (innovations_[i].resistance_known)
      fall_[i].add(innovations_[i].resistance.deviations, mean.count() == kCoils);
  }
  window_ = Window{};
  take_from_filter();
}

// Once per window: these take exponentials and roots.
void ThermalObserver::take_from_filter() noexcept {
  estimate_.nodes = filter_.nodes();
  estimate_.ambient_c = filter_.ambient_c();
  for (int coil = 0; coil < kCoils; ++coil) {
    const auto i = static_cast<std::size_t>(coil);
    expected_ohm_[i] = filter_.resistance_ohm(coil);
    estimate_.deviation_k[i] = filter_.winding_deviation_k(coil);
  }
}

void ThermalObserver::correct_winding(int coil) noexcept {
  const auto i = static_cast<std::size_t>(coil);
  if (window_.idle_ticks[i] == window_.ticks)
    filter_.idle_current(coil, window_.idle_a_sum[coil] / window_.ticks);
  WindowInnovations& innovations = innovations_[i];
  const WindingMeter& meter = thermometer_[i].meter();
  // The derivative is that of the previous window: the same noise in a measurement and in its
  // derivative would bias offset and temperature in opposite directions.
  const double before = std::exchange(per_ampere_[i], meter.per_ampere());
  const bool steady =
      std::abs(before - meter.per_ampere()) < kSteadyShare * std::abs(meter.per_ampere());
  innovations.resistance_known = window_.always_measured[i] && meter.resistance_ohm() > 0.0;
  if (!innovations.resistance_known) return;
  const double log_ratio = std::log(meter.resistance_ohm() / coils_.r25_ohm[i]);
  const double noise = std::hypot(meter.noise(), kMeterNoiseA / meter.current_a(), kMeterShare);
  innovations.resistance =
      filter_.resistance(coil, log_ratio, noise, steady ? before : meter.per_ampere());
}

double ThermalObserver::likely_c(int coil) const noexcept {
  const double deviation_k = estimate_.deviation_k[static_cast<std::size_t>(coil)];
  return filter_.winding_c(coil) + std::min(kLikelyDeviationsK, deviation_k);
}

double ThermalObserver::margin_k(int coil) const noexcept {
  return (thermistors_.count() < kCoils ? kSingleThermistorMarginK : 0.0) +
         (accuracy_.signs ? 0.0 : kUnsignedCurrentMarginK) +
         fall_[static_cast<std::size_t>(coil)].margin_k();
}

// While the start temperatures are only a guess, their uncertainty alone must not prevent V/I
// measurements.
double ThermalObserver::bound_by_filter(int coil) const noexcept {
  const double deviation_k = estimate_.deviation_k[static_cast<std::size_t>(coil)];
  const double bound_c = filter_.winding_c(coil) + kBoundDeviations * deviation_k + margin_k(coil);
  const bool probing = settling() && likely_c(coil) < kProbingC;
  return probing ? std::min(bound_c, kProbingC) : bound_c;
}

double ThermalObserver::floor_by_resistance(int coil) const noexcept {
  const WindingThermometer& thermometer = thermometer_[static_cast<std::size_t>(coil)];
  if (!thermometer.measuring() || !thermometer.referenced())
    return -std::numeric_limits<double>::infinity();
  return thermometer.celsius() - thermometer.bias_k() - thermometer.noise_k() +
         supply_error_k(coil);
}

void ThermalObserver::follow_supply(const ThermalMeasurement& m, double dt_s) noexcept {
  if (!m.electrical_valid || !is_finite(m.voltage_v) || !is_finite(m.current_a) ||
      !(m.supply_v > 0.0))
    return;
  const double drawn_a = std::abs(dot(m.voltage_v, m.current_a)) / m.supply_v;
  const double open_v = open_voltage(m.supply_v, drawn_a);
  if (supply_v_ == 0.0) supply_v_ = open_v;
  supply_v_ += (open_v - supply_v_) * dt_s / kSupplySmoothS;
  for (std::size_t i = 0; i < kCoils; ++i)
    if (thermometer_[i].comparing()) reference_supply_v_[i] = supply_v_;
}

// If the supply reading drifts down while the supply does not, V/I reads too cool. A winding with
// its own thermistor is checked by that instead.
double ThermalObserver::supply_error_k(int coil) const noexcept {
  const auto i = static_cast<std::size_t>(coil);
  if (thermistors_.valid[i] || !(reference_supply_v_[i] > 0.0)) return 0.0;
  const double fallen = 1.0 - supply_v_ / reference_supply_v_[i];
  return std::max(0.0, fallen - kSupplyRegulation) *
         kelvins_per_share(Celsius(thermometer_[i].celsius()));
}

void ThermalObserver::bound() noexcept {
  const int own = thermal_.sensor_winding;
  const double shown_c = sensor_.smooth_c() + kThermistorMarginK;
  double hottest = std::clamp(estimate_.sensor_lead_c + kThermistorMarginK, shown_c,
                              std::max(shown_c, filter_.winding_c(own) + kMaxLeadK));
  double likely = -std::numeric_limits<double>::infinity();
  for (int coil = 0; coil < kCoils; ++coil) {
    const auto i = static_cast<std::size_t>(coil);
    const double floor_c =
        std::max(floor_.winding_c(coil) + kFloorMarginK, floor_by_resistance(coil));
    estimate_.upper_c[i] = std::max(bound_by_filter(coil), floor_c + margin_k(coil));
    if (thermistors_.valid[i])
      estimate_.upper_c[i] =
          std::max(estimate_.upper_c[i], thermistors_.celsius[i] + kThermistorMarginK);
    hottest = std::max(hottest, estimate_.upper_c[i]);
    likely = std::max(likely, likely_c(coil));
  }
  estimate_.likely_c = likely;
  if (sensor_.lost()) hottest = std::numeric_limits<double>::infinity();
  estimate_.hottest_c = hottest;
}

}  // namespace hedgehog::model
