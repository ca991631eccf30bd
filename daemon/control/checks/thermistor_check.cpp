// SPDX-License-Identifier: MIT
#include "daemon/control/checks/thermistor_check.h"

#include <algorithm>
#include <cmath>

namespace hedgehog::control {
namespace {

constexpr double kQuickLagS = 1.0;
constexpr double kSlowLagS = 3.0;
// Between pulses the winding's last V/I is held for this long; then only the thermistor's own
// reading remains, and the lags converge to it.
constexpr double kPauseS = 2.0;
constexpr double kRelaxS = 3.0;

void low_pass(double& value, double goal, double dt_s, double tau_s) noexcept {
  value += (goal - value) * std::min(1.0, dt_s / tau_s);
}

bool is_informative(const SensorReading& reading) noexcept {
  return reading.measuring && reading.winding_error_k <= ThermistorCheck::kMaxWindingErrorK;
}

}  // namespace

Reason ThermistorCheck::step(const SensorReading& reading, double dt_s) noexcept {
  still_s_ += dt_s;
  plausible_age_s_ += dt_s;
  if (!reading.fresh) {
    if (still_s_ > kUnusedAfterS) usable_ = false;
    return Reason::kNone;  // lost telemetry is a fault of the link, not of the thermistor
  }
  const bool wire = reading.open || reading.shorted;
  const bool impossible = !wire && !(reading.sensor_c >= kLowestC && reading.sensor_c < kHighestC);
  const bool good = !wire && !impossible;
  if (!seen_ || reading.conversions != conversions_) still_s_ = 0.0;
  conversions_ = reading.conversions;
  if (!seen_ && good) {
    seen_ = true;
    plausible_c_ = quick_c_ = slow_c_ = reading.sensor_c;
    moved_sensor_c_ = moved_quick_c_ = moved_slow_c_ = reading.sensor_c;
  }
  const bool jump = good && jumped(reading, reading.since_s);
  if (good) follow_winding(reading, reading.since_s);
  const bool measuring = is_informative(reading);
  const bool is_frozen = good && measuring && frozen(reading);
  const bool odd =
      good && measuring && disagreement_k(reading.sensor_c) > kDisagreeK + reading.winding_error_k;

  Reason trip = Reason::kNone;
  arming_blocker_ = Reason::kNone;
  const auto check = [&](FaultDebounce& debounce, bool wrong, double hold_s,
                         Reason reason) noexcept {
    const bool due = debounce.step(wrong, reading.since_s, hold_s);
    if (trip == Reason::kNone && due) trip = reason;
    if (arming_blocker_ == Reason::kNone && debounce.pending()) arming_blocker_ = reason;
  };
  check(open_, reading.open, kWireHoldS, Reason::kSensorOpen);
  check(short_, reading.shorted, kWireHoldS, Reason::kSensorShort);
  check(implausible_, impossible, kImplausibleHoldS, Reason::kSensorImplausible);
  check(jump_, jump, kJumpHoldS, Reason::kSensorJump);
  if (still_s_ >= kStaleAfterS && trip == Reason::kNone) trip = Reason::kSensorStale;
  if (still_s_ > kUnusedAfterS && arming_blocker_ == Reason::kNone)
    arming_blocker_ = Reason::kSensorStale;
  check(frozen_, is_frozen, kFrozenHoldS, Reason::kSensorFrozen);
  check(disagrees_, odd, kDisagreeHoldS, Reason::kSensorDisagrees);
  usable_ = good && !jump && still_s_ <= kUnusedAfterS;
  return trip;
}

bool ThermistorCheck::jumped(const SensorReading& reading, double dt_s) noexcept {
  const double max_step_k = kJumpK + kSlewK_s * (plausible_age_s_ - dt_s);
  if (std::abs(reading.sensor_c - plausible_c_) > max_step_k) return true;
  plausible_c_ = reading.sensor_c;
  plausible_age_s_ = 0.0;
  return false;
}

void ThermistorCheck::follow_winding(const SensorReading& reading, double dt_s) noexcept {
  const bool measuring = is_informative(reading);
  unmeasured_s_ = measuring ? 0.0 : unmeasured_s_ + dt_s;
  if (measuring) winding_c_ = reading.winding_c;
  if (unmeasured_s_ > kPauseS) {
    low_pass(quick_c_, reading.sensor_c, dt_s, kRelaxS);
    low_pass(slow_c_, reading.sensor_c, dt_s, kRelaxS);
  } else {
    low_pass(quick_c_, winding_c_, dt_s, kQuickLagS);
    low_pass(slow_c_, winding_c_, dt_s, kSlowLagS);
  }
  if (unmeasured_s_ > kPauseS || std::abs(reading.sensor_c - moved_sensor_c_) >= kStillK) {
    moved_sensor_c_ = reading.sensor_c;
    moved_quick_c_ = quick_c_;
    moved_slow_c_ = slow_c_;
    min_bias_k_ = max_bias_k_ = reading.winding_bias_k;
  } else if (measuring) {
    min_bias_k_ = std::min(min_bias_k_, reading.winding_bias_k);
    max_bias_k_ = std::max(max_bias_k_, reading.winding_bias_k);
  }
}

bool ThermistorCheck::frozen(const SensorReading& reading) const noexcept {
  const double noise_k = reading.winding_error_k - reading.winding_bias_k;
  return std::min(std::abs(quick_c_ - moved_quick_c_), std::abs(slow_c_ - moved_slow_c_)) >=
         kFrozenK + (max_bias_k_ - min_bias_k_) + noise_k;
}

double ThermistorCheck::disagreement_k(double sensor_c) const noexcept {
  const auto [low, high] = std::minmax(quick_c_, slow_c_);
  return std::max({low - sensor_c, sensor_c - high, 0.0});
}

Disagreement disagreement_of(int coil, Reason reason) noexcept {
  switch (reason) {
    case Reason::kSensorFrozen:
    case Reason::kSensorDisagrees:
      return {coil, Quantity::kThermistor, Quantity::kResistance};
    case Reason::kSensorImplausible:
    case Reason::kSensorJump:
    case Reason::kSensorStale:
      return {coil, Quantity::kThermistor, Quantity::kHeatBalance};
    default:
      return {};
  }
}

}  // namespace hedgehog::control
