// SPDX-License-Identifier: MIT
#include "daemon/control/checks/supply_balance.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "model/estimate/supply_line.h"

namespace hedgehog::control {
namespace {

using model::kCoils;

constexpr double kWindowS = 0.02;
// Standard deviation of the gains at the start, and their random walk per root of a second.
constexpr double kGainDeviation = 0.02;
constexpr double kGainWalk = 1e-5;
// Offset, noise per window and unmodelled share of the supply current.
constexpr double kSupplyOffsetA = 0.02;
constexpr double kSupplyNoiseA = 0.02;
constexpr double kSumShare = 0.005;
// Errors are correlated from window to window: factor on their variance.
constexpr double kCorrelated = 25.0;
// An offset above this is one of a sensor without zeroing.
constexpr double kCoarseOffsetA = 0.05;
constexpr double kGate = 4.0;
constexpr double kCoarseGate = 5.0;
constexpr double kCoarseGain = 0.02;

// After this driving time the gains of this ball count as learned.
constexpr double kFirstS = 5.0;
constexpr double kRememberedS = 0.3;
// A change of V/I is explained by another quantity when that makes up at least the main share of
// it, and not explained when it makes up less than the minor share.
constexpr double kMainShare = 0.6;
constexpr double kMinorShare = 0.3;
// The current is excluded as the cause below this share, in either direction: 0.1 s after a step
// the means over kRememberedS contain 0.28 of it, and a change in the other direction does not
// prove a change of resistance.
constexpr double kExcludedShare = 0.2;
// Changes of the supply voltage below this share are not considered; and tolerance of a sound one
// about its nominal voltage, a share.
constexpr double kNoticed = 0.004;
constexpr double kSupplyTolerance = 0.045;
// A winding with a smaller part in the sum is not checked by it, A.
constexpr double kMinPartA = 0.4;

// Parts of the sum that have changed by less since the previous window count as unchanged, A.
constexpr double kSamePartA = 0.1;

constexpr double square(double v) noexcept { return v * v; }

template <class Row>
bool alike(const Row& a, const Row& b) noexcept {
  return std::equal(
      a.begin(), a.end(), b.begin(),
      [](double one, double other) { return std::abs(one - other) < kSamePartA; });
}

}  // namespace

SupplyBalance::SupplyBalance(double nominal_supply_v) noexcept
    : nominal_supply_v_(nominal_supply_v) {
  for (std::size_t i = 0; i < kCoils; ++i) p_[i][i] = square(kGainDeviation);
  p_[kOffset][kOffset] = square(kSupplyOffsetA);
}

double SupplyBalance::gain(int coil) const noexcept { return x_[static_cast<std::size_t>(coil)]; }

double SupplyBalance::gain_deviation(int coil) const noexcept {
  const auto i = static_cast<std::size_t>(coil);
  return std::sqrt(std::max(0.0, p_[i][i]));
}

Disagreement SupplyBalance::step(const SupplyReading& reading, double dt_s) noexcept {
  window_.s += dt_s;
  if (reading.known) {
    ++window_.readings;
    for (int coil = 0; coil < kCoils; ++coil) {
      window_.part_a[static_cast<std::size_t>(coil)] +=
          reading.duty[coil] * reading.current_a[coil];
      window_.duty_squared += square(reading.duty[coil]);
    }
    window_.supply_a += reading.supply_current_a;
    window_.supply_v += reading.supply_v;
    accuracy_ = reading.accuracy;
  }
  constexpr double kRounding = 1e-9;
  if (window_.s < kWindowS - kRounding) return {};
  last_age_s_ += window_.s;
  const Disagreement found = window_.readings > 0 ? check(window_.s) : Disagreement{};
  if (last_age_s_ > kMaxLastAgeS) last_ = Balance{};
  window_ = Window{};
  return found;
}

Disagreement SupplyBalance::check(double dt_s) noexcept {
  Row derivative{};
  double sum_a = 0.0;
  for (std::size_t i = 0; i < kCoils; ++i) {
    derivative[i] = -window_.part_a[i] / window_.readings;
    sum_a -= derivative[i];
    p_[i][i] += square(kGainWalk) * dt_s;
  }
  derivative[kOffset] = 1.0;
  remember(derivative);
  if (sum_a < kMinSumA) return {};
  double difference_a = window_.supply_a / window_.readings - sum_a;
  const double offset_a = accuracy_.offset_a;
  const double systematic = square(offset_a) * window_.duty_squared / window_.readings +
                            square(kSumShare * sum_a) + square(kSupplyNoiseA);
  double variance = systematic;
  for (std::size_t i = 0; i < kStates; ++i) {
    difference_a -= x_[i] * derivative[i];
    for (std::size_t j = 0; j < kStates; ++j) variance += derivative[i] * p_[i][j] * derivative[j];
  }
  const bool coarse = offset_a > kCoarseOffsetA;
  const bool odd = std::abs(difference_a) > (coarse ? kCoarseGate : kGate) * std::sqrt(variance);
  const bool stays_odd = odd_.step(odd, dt_s, kHoldS);
  // A measurement and a derivative with the same noise would move gain and offset against each
  // other with a bias, so the derivative of the previous window is used.
  const Row before = std::exchange(derivative_, derivative);
  if (!odd)
    update(alike(before, derivative) ? before : derivative, kCorrelated * systematic, difference_a);
  observed_s_ += dt_s;
  const int candidate = worst();
  const double max_gain = kGain + (coarse ? kCoarseGain : 0.0);
  const bool apart = apart_.step(certain_gain(candidate) > max_gain, dt_s, kGainHoldS);
  if (!stays_odd && !apart) return {};
  const auto most = std::min_element(derivative.begin(), derivative.begin() + kCoils);
  const int coil = apart ? candidate : static_cast<int>(most - derivative.begin());
  return {coil, Quantity::kCurrent, Quantity::kSupplyCurrent};
}

void SupplyBalance::update(const Row& derivative, double variance, double difference_a) noexcept {
  Row gain{};
  for (std::size_t i = 0; i < kStates; ++i)
    for (std::size_t j = 0; j < kStates; ++j) gain[i] += p_[i][j] * derivative[j];
  for (std::size_t i = 0; i < kStates; ++i) variance += gain[i] * derivative[i];
  for (std::size_t i = 0; i < kStates; ++i) {
    x_[i] += gain[i] / variance * difference_a;
    for (std::size_t j = 0; j < kStates; ++j) p_[i][j] -= gain[i] / variance * gain[j];
  }
}

double SupplyBalance::certain_gain(int coil) const noexcept {
  return std::abs(gain(coil)) - 2.0 * gain_deviation(coil);
}

int SupplyBalance::worst() const noexcept {
  static_assert(kCoils == 3);
  const auto worse = [this](int one, int other) {
    return certain_gain(other) > certain_gain(one) ? other : one;
  };
  return worse(worse(0, 1), 2);
}

void SupplyBalance::remember(const Row& derivative) noexcept {
  last_age_s_ = 0.0;
  last_.supply_v = model::open_voltage(window_.supply_v, window_.supply_a) / window_.readings;
  last_.missing_a = window_.supply_a / window_.readings;
  constexpr double kShare = kWindowS / kRememberedS;
  if (mean_.supply_v == 0.0) mean_.supply_v = last_.supply_v;
  for (std::size_t i = 0; i < kCoils; ++i) {
    last_.part_a[i] = -derivative[i];
    last_.missing_a += derivative[i];
  }
  mean_.missing_a += kShare * (last_.missing_a - mean_.missing_a);
  mean_.supply_v += kShare * (last_.supply_v - mean_.supply_v);
  for (std::size_t i = 0; i < kCoils; ++i)
    mean_.part_a[i] += kShare * (last_.part_a[i] - mean_.part_a[i]);
  if (observed_s_ > kFirstS) return;
  first_ = x_;
  for (int coil = 0; coil < kCoils; ++coil)
    first_deviation_[static_cast<std::size_t>(coil)] = gain_deviation(coil);
  first_supply_v_ = mean_.supply_v;
}

Disagreement SupplyBalance::moved(int coil, double share, Since since, By by) const noexcept {
  const Balance& now = by == By::kMeans ? mean_ : last_;
  const bool by_file = since == Since::kFile;
  // V/I changes with the measured voltage, and inversely with the current.
  const double voltage =
      now.supply_v > 0.0 ? std::log(now.supply_v / (by_file ? nominal_supply_v_ : first_supply_v_))
                         : 0.0;
  const double of_voltage = std::abs(voltage) > kNoticed ? voltage / share : 0.0;
  double missing_a = now.missing_a;
  if (!by_file) {
    missing_a -= first_[kOffset];
    for (std::size_t i = 0; i < kCoils; ++i) missing_a += first_[i] * now.part_a[i];
  }
  const auto i = static_cast<std::size_t>(coil);
  const double part_a = now.part_a[i];
  const bool clear =
      part_a > kMinPartA && (by_file || first_deviation_[i] < kMinorShare * std::abs(share));
  const double of_current = clear ? missing_a / part_a / share : 0.5;
  const double sound = by_file ? kSupplyTolerance : model::kSupplyRegulation;
  if (of_voltage > kMainShare && std::abs(voltage) > sound)
    return {coil, Quantity::kSupplyVoltage, Quantity::kHeatBalance};
  if (of_current > kMainShare) return {coil, Quantity::kCurrent, Quantity::kSupplyCurrent};
  const Disagreement found(coil, Quantity::kResistance, Quantity::kHeatBalance);
  if (of_voltage > kMinorShare || (!by_file && of_voltage < -kMinorShare))
    return found.with(Quantity::kSupplyVoltage);
  return std::abs(of_current) < kExcludedShare ? found : found.with(Quantity::kCurrent);
}

}  // namespace hedgehog::control
