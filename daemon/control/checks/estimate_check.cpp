// SPDX-License-Identifier: MIT
#include "daemon/control/checks/estimate_check.h"

#include <algorithm>
#include <cmath>

namespace hedgehog::control {
namespace {

// The cold-start resistance counts as known below this standard deviation, a share.
constexpr double kKnown = 0.008;
// Currents within this share of each other count as equal.
constexpr double kSameCurrent = 0.1;
constexpr double kSteadyAfterS = 0.5;
constexpr double kSmoothS = 0.1;
constexpr double kMeanS = 2.0;
// V/I is noisier at a low current; kelvins times amperes.
constexpr double kFallPerAmpereK = 12.0;
constexpr double kBiases = 4.0;
// With a thermistor offset beyond this, the thermistor may be the faulty one of the two.
constexpr double kOddThermistorK = 1.2;
// V/I that is higher than the filter expects by less, and its error, does not contradict it.
constexpr double kHeatShare = 0.01;

}  // namespace

Reason EstimateCheck::step(const model::ThermalObserver& observer, const SupplyBalance& supply,
                           double trip_c, double dt_s) noexcept {
  const bool hot = hot_.step(observer.estimate().likely_c >= trip_c, dt_s, kHotHoldS);
  const Disagreement found = check(observer, supply, dt_s);
  if (found.any()) disagreement_ = found;
  if (hot) return Reason::kOverheated;
  return found.any() ? Reason::kMeasurementsDisagree : Reason::kNone;
}

Disagreement EstimateCheck::check(const model::ThermalObserver& observer,
                                  const SupplyBalance& supply, double dt_s) noexcept {
  unchecked_s_ += dt_s;
  const bool window_ended = observer.window_ended();
  const double since_s = unchecked_s_;
  if (window_ended) unchecked_s_ = 0.0;
  Disagreement found;
  for (int coil = 0; coil < model::kCoils; ++coil) {
    Winding& winding = windings_[static_cast<std::size_t>(coil)];
    Move move = detect_fall(winding, observer.winding(coil), dt_s);
    bool thermistor = false;
    if (window_ended) {
      const Move window_move = moved(winding, observer, coil, since_s);
      if (window_move.share != 0.0) move = window_move;
      thermistor = thermistor_off(winding, observer, coil, since_s);
    }
    if (found.any()) continue;
    if (move.share != 0.0) {
      found = supply.moved(coil, move.share, move.since);
      const double offset_k = observer.filter().thermistor_offset_k(coil);
      if (std::abs(offset_k) > kOddThermistorK) found = found.with(Quantity::kThermistor);
    } else if (thermistor) {
      found = {coil, Quantity::kThermistor, Quantity::kHeatBalance};
    }
  }
  return observer.settling() ? Disagreement{} : found;
}

EstimateCheck::Move EstimateCheck::detect_fall(Winding& w,
                                               const model::WindingThermometer& thermometer,
                                               double dt_s) noexcept {
  const bool clear = thermometer.measuring() && thermometer.referenced();
  if (!clear || thermometer.noise_k() > kFallK) {
    w.steady = false;
    return {};
  }
  const double celsius = thermometer.celsius();
  const double current_a = thermometer.meter().current_a();
  if (!w.steady || std::abs(current_a / w.steady_a - 1.0) > kSameCurrent) {
    w.steady = true;
    w.steady_s = 0.0;
    w.steady_a = current_a;
    w.smooth_c = w.mean_c = celsius;
  }
  w.steady_s += dt_s;
  w.smooth_c += (celsius - w.smooth_c) * (dt_s / kSmoothS);
  w.mean_c += (w.smooth_c - w.mean_c) * (dt_s / kMeanS);
  const double max_k = kFallK + kBiases * thermometer.bias_k() + kFallPerAmpereK / current_a;
  const bool falls = w.steady_s > kSteadyAfterS && w.mean_c - w.smooth_c > max_k;
  const double share = (w.smooth_c - w.mean_c) / kelvins_per_share(model::Celsius(w.mean_c));
  return {w.fall.step(falls, dt_s, kFallHoldS) ? share : 0.0};
}

EstimateCheck::Move EstimateCheck::moved(Winding& w, const model::ThermalObserver& observer,
                                         int coil, double dt_s) noexcept {
  const auto& innovations = observer.innovations(coil);
  if (!innovations.resistance_known) {
    w.gate.step(false, dt_s, kResistanceHoldS);
    return {};
  }
  const model::Innovation& innovation = innovations.resistance;
  const bool gated = w.gate.step(!innovation.used, dt_s, kResistanceHoldS);
  const model::ThermalFilter& filter = observer.filter();
  const double resistance = filter.resistance_drift(coil);
  const double deviation = filter.resistance_drift_deviation(coil);
  if (!w.known && deviation < kKnown) {
    w.known = true;
    w.resistance = resistance;
  }
  const double drift = w.known ? resistance - w.resistance : 0.0;
  const double current_a = observer.winding(coil).meter().current_a();
  const double by_offset = filter.current_offset_deviation_a(coil) / current_a;
  const bool drifts = std::abs(drift) > kDrift + 2.0 * deviation;
  const bool foreign = std::abs(resistance) - std::hypot(deviation, by_offset) > kFileDrift;
  const bool off = w.drift.step(drifts || foreign, dt_s, kDriftHoldS);
  if (gated || observer.fall(coil).certain()) return {innovation.difference + drift};
  if (!off) return {};
  return drifts ? Move{drift} : Move{resistance, SupplyBalance::Since::kFile};
}

bool EstimateCheck::thermistor_off(Winding& w, const model::ThermalObserver& observer, int coil,
                                   double dt_s) noexcept {
  const auto& innovations = observer.innovations(coil);
  if (!innovations.thermistor_known) {
    w.thermistor.step(false, dt_s, kThermistorHoldS);
    return false;
  }
  const bool odd =
      !innovations.thermistor.used && std::abs(innovations.thermistor.difference) > kThermistorK;
  const bool gated = w.thermistor.step(odd, dt_s, kThermistorHoldS);
  return gated || std::abs(observer.filter().thermistor_offset_k(coil)) > kThermistorOffsetK;
}

Disagreement EstimateCheck::contradicting_heat(const model::ThermalObserver& observer,
                                               const SupplyBalance& supply,
                                               double trip_c) const noexcept {
  using Since = SupplyBalance::Since;
  const model::ThermalFilter& filter = observer.filter();
  const model::ThermistorReadings& thermistors = observer.thermistors();
  if (observer.settling()) return {};
  for (int coil = 0; coil < model::kCoils; ++coil) {
    const auto i = static_cast<std::size_t>(coil);
    const double expected_c = filter.winding_c(coil);
    const double deviation_k = 2.0 * filter.winding_deviation_k(coil);
    if (expected_c + deviation_k >= trip_c) continue;
    const model::WindingThermometer& thermometer = observer.winding(coil);
    if (thermometer.measuring() && thermometer.celsius() >= trip_c) {
      const bool known = windings_[i].known;
      const double share = std::log(thermometer.resistance_ohm() / filter.resistance_ohm(coil));
      const double error_k = thermometer.noise_k() + thermometer.bias_k() + deviation_k;
      const double error = error_k / kelvins_per_share(model::Celsius(expected_c));
      if (share > (known ? kHeatShare : kFileDrift) + error)
        return supply.moved(coil, share, known ? Since::kStart : Since::kFile,
                            SupplyBalance::By::kLastWindow);
    }
    const double excess_k = thermistors.celsius[i] - expected_c;
    if (thermistors.valid[i] && thermistors.celsius[i] >= trip_c &&
        excess_k > kThermistorK + deviation_k)
      return {coil, Quantity::kThermistor, Quantity::kHeatBalance};
  }
  return {};
}

}  // namespace hedgehog::control
