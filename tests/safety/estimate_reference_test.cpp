// SPDX-License-Identifier: MIT
// Estimate, checks and limiter against reference figures (`reference/estimates.tsv`), for each
// electronics and each kind of failure. The other tests specify the required behaviour; this one
// records the actual behaviour, so that a changed constant or sign is detected and must be
// intended. HEDGEHOG_WRITE_REFERENCE=1 rewrites the figures.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <optional>
#include <string>

#include "tests/folders.h"
#include "tests/rig/reference_record.h"
#include "tests/rig/thermal_ball.h"

namespace hedgehog::rig {
namespace {

using device::FrontEndChoice;
using device::FrontEndKind;
using device::SimulatorError;
using device::SimulatorErrorKind;

constexpr int kSteps = 3000;

struct Case {
  const char* name;
  FrontEndChoice front_end;
  std::optional<SimulatorError> error{};
  double start_c = 25.0;
  bool known = true;
  double tolerance = 0.2;
  /// The step at which the error begins.
  int step = 500;
  std::optional<SimulatorError> second{};
};

constexpr SimulatorErrorKind kResistance = SimulatorErrorKind::kResistanceGain;

constexpr FrontEndChoice kThree{FrontEndKind::kInLine, 3, 0};
constexpr FrontEndChoice kOne{FrontEndKind::kInLine, 1, 0};
constexpr FrontEndChoice kCs{FrontEndKind::kDriverCs, 1, 0};

constexpr SimulatorError error(SimulatorErrorKind kind, std::uint8_t coil, double value,
                               double ramp_s = 0.0) {
  return {kind, coil, value, ramp_s};
}

const std::array kCases{
    Case{"healthy", kThree},
    Case{"healthy_one", kOne},
    Case{"healthy_cs", kCs},
    Case{"warm", kThree, {}, 52.0},
    Case{"unknown", kThree, {}, 40.0, false},
    Case{"unknown_one", kOne, {}, 30.0, false},
    Case{"unknown_cs", kCs, {}, 45.0, false},
    Case{"calibrated", kOne, {}, 35.0, true, 0.05},
    Case{"gain", kThree, error(SimulatorErrorKind::kCurrentGain, 1, 1.1)},
    Case{"gain_one", kOne, error(SimulatorErrorKind::kCurrentGain, 1, 1.06, 8.0)},
    Case{"gain_cs", kCs, error(SimulatorErrorKind::kCurrentGain, 2, 0.85)},
    Case{"offset", kThree, error(SimulatorErrorKind::kCurrentOffsetA, 1, 0.5)},
    Case{"offset_one", kOne, error(SimulatorErrorKind::kCurrentOffsetA, 2, -0.3, 5.0)},
    Case{"supply", kThree, error(SimulatorErrorKind::kSupplyGain, 0, 0.9)},
    Case{"supply_one", kOne, error(SimulatorErrorKind::kSupplyGain, 0, 0.95, 10.0)},
    Case{"supply_cs", kCs, error(SimulatorErrorKind::kSupplyGain, 0, 0.93)},
    Case{"resistance", kThree, error(SimulatorErrorKind::kResistanceGain, 1, 0.9)},
    Case{"resistance_one", kOne, error(SimulatorErrorKind::kResistanceGain, 2, 0.96)},
    Case{"shorted", kThree, error(SimulatorErrorKind::kShortedTurns, 1, 0.1, 15.0)},
    Case{"shorted_one", kOne, error(SimulatorErrorKind::kShortedTurns, 1, 0.05, 20.0), 45.0},
    Case{"shorted_cs", kCs, error(SimulatorErrorKind::kShortedTurns, 1, 0.3)},
    Case{"thermistor", kThree, error(SimulatorErrorKind::kThermistorOffsetK, 2, -6.0)},
    Case{"thermistor_one", kOne, error(SimulatorErrorKind::kThermistorOffsetK, 0, -3.0, 10.0)},
    Case{"contact", kThree, error(SimulatorErrorKind::kThermistorContact, 1, 1.0)},
    Case{"cooling", kThree, error(SimulatorErrorKind::kCoolingGain, 0, 0.3), 50.0},
    Case{"capacity", kOne, error(SimulatorErrorKind::kHeatCapacityGain, 0, 0.7)},
    Case{"tach", kThree, error(SimulatorErrorKind::kTachGain, 0, 0.5), 48.0},
    // Soon after a change of the current, and much later.
    Case{"fall_soon", kThree, error(kResistance, 1, 0.94), 25.0, true, 0.2, 810},
    Case{"fall_soon_one", kOne, error(kResistance, 1, 0.93), 30.0, true, 0.2, 805},
    Case{"fall_late", kThree, error(kResistance, 1, 0.97), 35.0, true, 0.2, 1350},
    Case{"fall_other", kOne, error(kResistance, 1, 0.955), 30.0, true, 0.2, 1270},
    Case{"fall_noisy", kCs, error(kResistance, 1, 0.9), 30.0, true, 0.2, 840},
    // Too slow for any innovation gate.
    Case{"rises", kThree, error(kResistance, 1, 1.05, 30.0)},
    Case{"rises_one", kOne, error(kResistance, 1, 1.06, 25.0), 40.0},
    Case{"falls", kThree, error(kResistance, 1, 0.95, 30.0)},
    Case{"falls_one", kOne, error(kResistance, 2, 0.93, 40.0), 40.0},
    Case{"reads_low", kThree, error(SimulatorErrorKind::kCurrentGain, 1, 0.96, 25.0)},
    Case{"reads_low_one", kOne, error(SimulatorErrorKind::kCurrentGain, 1, 0.95, 35.0)},
    Case{"supply_slow", kThree, error(SimulatorErrorKind::kSupplyGain, 0, 1.05, 30.0)},
    Case{"supply_slow_cs", kCs, error(SimulatorErrorKind::kSupplyGain, 0, 1.06, 30.0)},
    // A ball with a resistance that differs from the device file.
    Case{"foreign", kThree, error(kResistance, 1, 0.88), 30.0, false, 0.2, 0},
    Case{"foreign_one", kOne, error(kResistance, 1, 1.12), 30.0, false, 0.2, 0},
    Case{"foreign_known", kOne, error(kResistance, 2, 0.9), 30.0, true, 0.2, 0},
    // Two errors at once.
    Case{"odd_thermistor", kThree, error(SimulatorErrorKind::kThermistorOffsetK, 1, -1.8, 5.0),
         25.0, true, 0.2, 200, error(kResistance, 1, 0.95, 20.0)},
    Case{"odd_thermistor_one", kOne, error(SimulatorErrorKind::kThermistorOffsetK, 0, 2.5, 5.0),
         25.0, true, 0.2, 200, error(kResistance, 0, 0.94, 20.0)},
    Case{"thermistor_slow", kThree, error(SimulatorErrorKind::kThermistorOffsetK, 2, 5.0, 40.0)},
};

/// Each winding alone and all together, from rest to 15 A, both signs, steady and pulsed.
model::Vec3 requested_at(int step) {
  const int second = step / 50;
  switch (second % 15) {
    case 0:
      return {};
    case 1:
    case 2:
      return {0.0, 8.0, 0.0};
    case 3:
      return {4.0, -3.0, 2.0};
    case 4:
    case 5:
      return {0.0, 0.0, -15.0};
    case 6:
      return step % 10 < 5 ? model::Vec3{12.0, 0.0, 0.0} : model::Vec3{};
    case 7:
      return {-6.0, 6.0, 1.0};
    case 8:
      return {0.0, step % 25 < 3 ? 10.0 : 0.0, 0.0};
    case 9:
    case 10:
    case 11:
      return {2.0, 13.0, 5.0};
    case 12:
      return {};
    case 13:
      return {9.0, -9.0, 9.0};
    default:
      return {0.2, 5.0, -1.6};
  }
}

ThermalBallOptions options_of(const Case& one, std::uint64_t seed) {
  ThermalBallOptions options = family_ball(seed, one.front_end, one.tolerance);
  options.known = one.known;
  options.board.start_c = std::max(one.start_c, options.board.ambient_c);
  return options;
}

/// Figures of the observer, the supply balance and the watchdog's own thermometers.
ReferenceRecord::Figures figures_of(const ThermalBall& ball) {
  const model::ThermalObserver& observer = ball.observer();
  const model::ThermalEstimate& estimate = observer.estimate();
  const model::ThermalFilter& filter = observer.filter();
  ReferenceRecord::Figures all{{"core_c", filter.core_c()},
                               {"ambient_c", filter.ambient_c()},
                               {"cooling", filter.cooling()},
                               {"between_k", filter.between_deviation_k(0.7)},
                               {"hottest_c", std::min(999.0, estimate.hottest_c)},
                               {"likely_c", estimate.likely_c},
                               {"lead_c", estimate.sensor_lead_c},
                               {"allowed_a", ball.allowed_a()},
                               {"skin_c", ball.skin().celsius()}};
  for (int coil = 0; coil < model::kCoils; ++coil) {
    const auto i = static_cast<std::size_t>(coil);
    const auto add = [&](const char* name, double value) {
      all.emplace_back(std::string(name) + "xyz"[coil], value);
    };
    const model::WindingThermometer& winding = observer.winding(coil);
    const bool measuring = winding.measuring();
    add("winding_c_", filter.winding_c(coil));
    add("deviation_k_", filter.winding_deviation_k(coil));
    add("upper_c_", estimate.upper_c[i]);
    add("ohm_", estimate.resistance_ohm[i]);
    add("drift_", 1e3 * filter.resistance_drift(coil));
    add("drift_deviation_", 1e3 * filter.resistance_drift_deviation(coil));
    add("offset_a_", filter.current_offset_a(coil));
    add("offset_deviation_a_", filter.current_offset_deviation_a(coil));
    add("thermistor_c_", filter.thermistor_c(coil));
    add("thermistor_offset_k_", filter.thermistor_offset_k(coil));
    add("fall_k_", observer.fall(coil).margin_k());
    add("vi_c_", winding.celsius());
    add("vi_noise_k_", measuring ? winding.noise_k() : 0.0);
    add("vi_bias_k_", measuring ? winding.bias_k() : 0.0);
    add("innovation_", observer.innovations(coil).resistance.deviations);
    add("thermistor_innovation_", observer.innovations(coil).thermistor.deviations);
    add("heat_c_", ball.heat().winding_c(coil));
    add("gain_", ball.supply().gain(coil));
    add("gain_deviation_", ball.supply().gain_deviation(coil));
    const auto moved = [&](double share, control::SupplyBalance::Since since) {
      const control::Disagreement found = ball.supply().moved(coil, share, since);
      double bits = 0.0;
      for (int q = 0; q < control::kQuantities; ++q)
        bits += found.has(static_cast<control::Quantity>(q)) ? std::ldexp(1.0, q) : 0.0;
      return bits;
    };
    add("moved_", moved(-0.05, control::SupplyBalance::Since::kStart));
    add("off_", moved(0.05, control::SupplyBalance::Since::kFile));
  }
  return all;
}

/// Sums over the run, so that short deviations contribute too.
class Sums {
 public:
  void add(const ReferenceRecord::Figures& figures) {
    if (sums_.empty()) {
      sums_ = figures;
      return;
    }
    for (std::size_t i = 0; i < sums_.size(); ++i) sums_[i].second += figures[i].second;
  }
  const ReferenceRecord::Figures& figures() const { return sums_; }

 private:
  ReferenceRecord::Figures sums_;
};

TEST(EstimateReference, ItsFiguresAreThoseOfTheTable) {
  ReferenceRecord record;
  std::uint64_t seed = 7001;
  for (const Case& one : kCases) {
    ThermalBall ball(options_of(one, seed++));
    Sums sums;
    int stopped_at = -1;
    for (int step = 0; step < kSteps; ++step) {
      if (step == one.step && one.error) {
        device::SimulatorErrorList errors;
        errors.generation = 1;
        errors.error[errors.count++] = *one.error;
        if (one.second) errors.error[errors.count++] = *one.second;
        ball.set_errors(errors);
      }
      ball.step(requested_at(step), step % 300 < 100 ? 0.7 : 1.0);
      if (step % 5 == 0) sums.add(figures_of(ball));
      if (stopped_at < 0 && ball.stop().any()) stopped_at = step;
    }
    const std::string name = one.name;
    const auto row = [&](const std::string& kind, ReferenceRecord::Figures figures) {
      figures.emplace_back("stopped_at", stopped_at);
      figures.emplace_back("stop", static_cast<double>(ball.stop().reason));
      figures.emplace_back("stop_coil", ball.stop().disagreement.coil());
      record.add(name + "_" + kind, figures);
    };
    row("sum", sums.figures());
    row("end", figures_of(ball));
  }
  EXPECT_EQ(record.differences(source_folder() + "/tests/safety/reference/estimates.tsv"), "");
}

}  // namespace
}  // namespace hedgehog::rig
