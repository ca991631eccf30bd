// SPDX-License-Identifier: MIT
#include "model/estimate/thermal_filter.h"

#include <algorithm>
#include <cmath>

namespace hedgehog::model {
namespace {

constexpr double square(double v) noexcept { return v * v; }

// Standard deviation of a uniform distribution over +-1.
constexpr double kEvenDeviation = 0.6;
// Initial loss of contact: a thermistor never touches its winding on all sides.
constexpr double kLostContactStart = 0.05;
constexpr double kLostContactDeviation = 0.06;
constexpr double kMaxLostContact = 0.6;

// Random walk of the states, per square root of a second.
constexpr double kWindingWalkK = 0.02;
constexpr double kCoreWalkK = 0.02;
constexpr double kBodyWalkK = 0.01;
constexpr double kAmbientWalkK = 0.02;
constexpr double kResistanceWalk = 2e-5;
constexpr double kNetworkWalk = 5e-4;
constexpr double kCoolingWalk = 3e-3;
constexpr double kCurrentOffsetWalkA = 1e-4;
constexpr double kThermistorOffsetWalkK = 1e-3;
constexpr double kLostContactWalk = 1e-4;
// Relative uncertainty of a thermistor's lag.
constexpr double kLagShare = 0.5;

constexpr double kMaxCooling = 0.7;
constexpr double kMinCooling = -1.2;
constexpr double kMaxCoolingDeviation = 0.5;
constexpr double kMaxAmbientDeviationK = 3.0;
constexpr double kMaxOffsets = 2.0;

// Standard deviation of a thermistor reading: noise and resolution, K.
constexpr double kThermistorReadingK = 0.3;
constexpr double kIdleReadingA = 0.03;

}  // namespace

ThermalFilter::ThermalFilter(const CoilModel& coils, const ThermalModel& thermal,
                             const ThermalUncertainty& uncertainty,
                             const FilterStart& start) noexcept
    : coils_(coils), thermal_(thermal) {
  for (int coil = 0; coil < kCoils; ++coil) {
    set_variance(at(kResistance, coil), uncertainty.resistance);
    set_variance(at(kWarming, coil), kEvenDeviation * uncertainty.thermal);
    set_variance(at(kConduction, coil), kEvenDeviation * uncertainty.thermal);
    set_variance(at(kThermistorOffset, coil), uncertainty.thermistor_k);
    set_variance(at(kLostContact, coil), kLostContactDeviation);
    x_[at(kLostContact, coil)] = kLostContactStart;
  }
  set_variance(kCooling, kEvenDeviation * uncertainty.thermal);
  start_nodes(start);
}

void ThermalFilter::start_nodes(const FilterStart& start) noexcept {
  constexpr std::array kTemperatures{kWinding, kWinding + 1, kWinding + 2, kCore,
                                     kAmbient, kBody,        kBody + 1,    kBody + 2};
  for (std::size_t i = 0; i < kCoils; ++i) {
    x_[kWinding + i] = start.nodes.winding_c[i];
    x_[kBody + i] = start.nodes.winding_c[i];
  }
  x_[kCore] = start.nodes.core_c;
  x_[kAmbient] = start.ambient_c;
  for (const std::size_t a : kTemperatures) {
    for (const std::size_t b : kTemperatures) p_[a][b] = square(start.common_k);
    p_[a][a] += square(start.single_k);
    // All start at the thermistor's reading: a common error is its offset.
    const std::size_t own = at(kThermistorOffset, thermal_.sensor_winding);
    p_[a][own] = p_[own][a] = -square(start.common_k);
  }
  set_variance(
      at(kThermistorOffset, thermal_.sensor_winding),
      std::max(deviation(at(kThermistorOffset, thermal_.sensor_winding)), start.common_k + 0.01));
}

void ThermalFilter::set_current_accuracy(const CurrentAccuracy& accuracy) noexcept {
  max_offset_a_ = kMaxOffsets * accuracy.offset_a;
  for (int coil = 0; coil < kCoils; ++coil) {
    const std::size_t offset = at(kCurrentOffset, coil);
    for (std::size_t i = 0; i < kStates; ++i) p_[offset][i] = p_[i][offset] = 0.0;
    x_[offset] = 0.0;
    set_variance(offset, kEvenDeviation * accuracy.offset_a);
  }
}

double ThermalFilter::deviation(std::size_t state) const noexcept {
  return std::sqrt(std::max(0.0, p_[state][state]));
}

void ThermalFilter::set_variance(std::size_t state, double deviation) noexcept {
  p_[state][state] = square(deviation);
}

double ThermalFilter::between_deviation_k(double share) const noexcept {
  const double rest = 1.0 - share;
  return std::sqrt(std::max(0.0, share * share * p_[kCore][kCore] +
                                     rest * rest * p_[kAmbient][kAmbient] +
                                     2.0 * share * rest * p_[kCore][kAmbient]));
}

double ThermalFilter::cooling() const noexcept { return std::exp(x_[kCooling]); }

ThermalState ThermalFilter::nodes() const noexcept {
  return {{winding_c(0), winding_c(1), winding_c(2)}, core_c()};
}

double ThermalFilter::resistance_ohm(int coil) const noexcept {
  const double r25 = coils_.r25_ohm[static_cast<std::size_t>(coil)];
  return std::exp(resistance_drift(coil)) *
         resistance_at(Ohms(r25), Celsius(winding_c(coil))).value;
}

void ThermalFilter::predict(const std::array<double, kCoils>& loss_w, bool fan_running,
                            double dt_s) noexcept {
  std::array<Row, kMoving> jacobian{};
  const std::array<double, kMoving> step = move(loss_w, fan_running, dt_s, jacobian);
  propagate(jacobian);
  // The uncertainty of the lag makes the bodies uncertain by a share of their distance from the
  // winding.
  for (int coil = 0; coil < kCoils; ++coil) {
    const double behind_k = winding_c(coil) - thermistor_c(coil);
    p_[at(kBody, coil)][at(kBody, coil)] +=
        2.0 * dt_s * square(kLagShare * behind_k / thermal_.sensor_lag_s);
  }
  for (std::size_t i = 0; i < kCoils; ++i) {
    x_[kWinding + i] += step[i];
    x_[kBody + i] += step[kCoils + 1 + i];
  }
  x_[kCore] += step[kCoils];
  spread(dt_s);
  limit_state();
}

// Rows of the Jacobian: windings, core, bodies. Columns: all states.
std::array<double, ThermalFilter::kMoving> ThermalFilter::move(
    const std::array<double, kCoils>& loss_w, bool fan_running, double dt_s,
    std::array<Row, kMoving>& jacobian) noexcept {
  std::array<double, kMoving> step{};
  Row& core = jacobian[kCoils];
  const double per_core = dt_s / thermal_.core_j_k;
  const double to_ambient_k_w =
      fan_running ? thermal_.core_to_ambient_fan_k_w : thermal_.core_to_ambient_still_k_w;
  const double cooling_w_k = std::exp(x_[kCooling]) / to_ambient_k_w;
  double into_core_w = cooling_w_k * (x_[kAmbient] - x_[kCore]);
  core[kCore] = 1.0 - per_core * cooling_w_k;
  core[kAmbient] = per_core * cooling_w_k;
  core[kCooling] = per_core * into_core_w;
  for (std::size_t i = 0; i < kCoils; ++i) {
    const double conductance_w_k = std::exp(x_[kConduction + i]) / thermal_.winding_to_core_k_w[i];
    const double to_core_w = conductance_w_k * (x_[kWinding + i] - x_[kCore]);
    const double per_winding = dt_s * std::exp(x_[kWarming + i]) / thermal_.winding_j_k[i];
    into_core_w += to_core_w;
    step[i] = per_winding * (loss_w[i] - to_core_w);
    Row& winding = jacobian[i];
    winding[kWinding + i] = 1.0 - per_winding * conductance_w_k;
    winding[kCore] = per_winding * conductance_w_k;
    winding[kWarming + i] = step[i];
    winding[kConduction + i] = -per_winding * to_core_w;
    core[kWinding + i] = per_core * conductance_w_k;
    core[kCore] -= per_core * conductance_w_k;
    core[kConduction + i] = per_core * to_core_w;

    const double lag = std::min(1.0, dt_s / thermal_.sensor_lag_s);
    const double lost = x_[kLostContact + i];
    const double above_k = x_[kWinding + i] - x_[kCore];
    step[kCoils + 1 + i] = lag * (x_[kWinding + i] - lost * above_k - x_[kBody + i]);
    Row& body = jacobian[kCoils + 1 + i];
    body[kWinding + i] = lag * (1.0 - lost);
    body[kCore] = lag * lost;
    body[kLostContact + i] = -lag * above_k;
    body[kBody + i] = 1.0 - lag;
  }
  step[kCoils] = per_core * into_core_w;
  return step;
}

// P = F P F^T, where F differs from the identity in the rows of the moving states only.
void ThermalFilter::propagate(const std::array<Row, kMoving>& jacobian) noexcept {
  constexpr std::array<std::size_t, kMoving> kRows{kWinding, kWinding + 1, kWinding + 2, kCore,
                                                   kBody,    kBody + 1,    kBody + 2};
  std::array<Row, kMoving> moved{};
  for (std::size_t r = 0; r < kMoving; ++r) {
    for (std::size_t k = 0; k < kStates; ++k) {
      const double factor = jacobian[r][k];
      if (factor == 0.0) continue;
      for (std::size_t j = 0; j < kStates; ++j) moved[r][j] += factor * p_[k][j];
    }
  }
  for (std::size_t r = 0; r < kMoving; ++r) p_[kRows[r]] = moved[r];
  std::array<std::array<double, kStates>, kMoving> columns{};
  for (std::size_t r = 0; r < kMoving; ++r) {
    for (std::size_t k = 0; k < kStates; ++k) {
      const double factor = jacobian[r][k];
      if (factor == 0.0) continue;
      for (std::size_t i = 0; i < kStates; ++i) columns[r][i] += factor * p_[i][k];
    }
  }
  for (std::size_t r = 0; r < kMoving; ++r)
    for (std::size_t i = 0; i < kStates; ++i) p_[i][kRows[r]] = columns[r][i];
  for (std::size_t r = 0; r < kMoving; ++r)
    for (std::size_t i = 0; i < kStates; ++i) p_[kRows[r]][i] = p_[i][kRows[r]];
}

void ThermalFilter::spread(double dt_s) noexcept {
  const auto walk = [&](std::size_t state, double per_root_s) noexcept {
    p_[state][state] += square(per_root_s) * dt_s;
  };
  for (int coil = 0; coil < kCoils; ++coil) {
    walk(at(kWinding, coil), kWindingWalkK);
    walk(at(kBody, coil), kBodyWalkK);
    walk(at(kResistance, coil), kResistanceWalk);
    walk(at(kWarming, coil), kNetworkWalk);
    walk(at(kConduction, coil), kNetworkWalk);
    walk(at(kCurrentOffset, coil), kCurrentOffsetWalkA);
    walk(at(kThermistorOffset, coil), kThermistorOffsetWalkK);
    walk(at(kLostContact, coil), kLostContactWalk);
  }
  walk(kCore, kCoreWalkK);
  walk(kAmbient, kAmbientWalkK);
  walk(kCooling, kCoolingWalk);
}

void ThermalFilter::limit_state() noexcept {
  const auto limit_variance = [&](std::size_t state, double max_deviation) noexcept {
    p_[state][state] = std::min(p_[state][state], square(max_deviation));
  };
  x_[kCooling] = std::clamp(x_[kCooling], kMinCooling, kMaxCooling);
  limit_variance(kCooling, kMaxCoolingDeviation);
  limit_variance(kAmbient, kMaxAmbientDeviationK);
  for (int coil = 0; coil < kCoils; ++coil) {
    double& lost = x_[at(kLostContact, coil)];
    lost = std::clamp(lost, 0.0, kMaxLostContact);
    double& offset = x_[at(kCurrentOffset, coil)];
    offset = std::clamp(offset, -max_offset_a_, max_offset_a_);
  }
}

template <std::size_t N>
Innovation ThermalFilter::measure(const std::array<Term, N>& terms, double difference,
                                  double deviation) noexcept {
  Row gain{};
  for (const Term& term : terms)
    for (std::size_t i = 0; i < kStates; ++i) gain[i] += p_[term.state][i] * term.derivative;
  double variance = square(deviation);
  for (const Term& term : terms) variance += term.derivative * gain[term.state];
  Innovation innovation{difference, difference / std::sqrt(variance), false};
  if (!(std::abs(innovation.deviations) <= kGate)) return innovation;
  innovation.used = true;
  for (std::size_t i = 0; i < kStates; ++i) {
    const double share = gain[i] / variance;
    x_[i] += share * difference;
    for (std::size_t j = i; j < kStates; ++j) p_[i][j] -= share * gain[j];
    for (std::size_t j = 0; j < i; ++j) p_[i][j] = p_[j][i];
  }
  limit_state();
  return innovation;
}

Innovation ThermalFilter::resistance(int coil, double log_ratio, double deviation,
                                     double per_ampere) noexcept {
  const double warmth = 1.0 + kCopperPerKelvin * (winding_c(coil) - 25.0);
  const double offset = current_offset_a(coil);
  const double expected = resistance_drift(coil) + std::log(warmth) - per_ampere * offset;
  return measure(std::array{Term{at(kResistance, coil), 1.0},
                            Term{at(kWinding, coil), kCopperPerKelvin / warmth},
                            Term{at(kCurrentOffset, coil), -per_ampere}},
                 log_ratio - expected, deviation);
}

Innovation ThermalFilter::thermistor(int coil, double celsius) noexcept {
  return measure(std::array{Term{at(kBody, coil), 1.0}, Term{at(kThermistorOffset, coil), 1.0}},
                 celsius - thermistor_c(coil) - thermistor_offset_k(coil), kThermistorReadingK);
}

void ThermalFilter::idle_current(int coil, double current_a) noexcept {
  measure(std::array{Term{at(kCurrentOffset, coil), 1.0}}, current_a - current_offset_a(coil),
          kIdleReadingA);
}

}  // namespace hedgehog::model
