// SPDX-License-Identifier: MIT
#include "model/identification/heating_plan.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace hedgehog::model {
namespace {

/// Probe current in each winding while cooling, with alternating sign so that the offset of a
/// current sensor is observable.
constexpr double kMeasureA = 2.9;
constexpr double kMeasureS = 1.5;
constexpr double kBurstA = 15.0;
constexpr double kBurstS = 8.0;
constexpr double kHeatA = 7.0;
constexpr double kHeatS = 240.0;
constexpr double kSteadyA = 5.0;
constexpr double kSteadyS = 240.0;
constexpr double kStepS = 2.0;
/// Short strong pulses: maximum heat at a mean current below the fan's threshold (3 A).
constexpr double kPulseA = 12.0;
constexpr double kPulseS = 1.0;
constexpr double kPulseEveryS = 5.0;
constexpr double kPulsesS = 90.0;

class Plan {
 public:
  explicit Plan(double max_a) : max_a_(max_a) {}

  void cool(std::string_view phase, double duration_s, double every_s) {
    for (double s = 0.0; s < duration_s; s += every_s) {
      look(phase);
      idle(phase, every_s - kMeasureS);
    }
  }
  void heat(std::string_view phase, const Vec3& direction, double current_a, double duration_s) {
    const double scale = std::min(current_a, max_a_) / norm(direction);
    for (double s = 0.0; s < duration_s; s += kStepS)
      steps_.push_back({phase, std::min(kStepS, duration_s - s), scale * direction});
  }
  void pulse(std::string_view phase, const Vec3& direction) {
    for (double s = 0.0; s < kPulsesS; s += kPulseEveryS) {
      heat(phase, direction, kPulseA, kPulseS);
      idle(phase, kPulseEveryS - kPulseS);
    }
  }
  std::vector<HeatingStep> take() { return std::move(steps_); }

 private:
  void look(std::string_view phase) {
    sign_ = -sign_;
    const double each_a = std::min(kMeasureA, max_a_ / 2.0);
    steps_.push_back({phase, kMeasureS, sign_ * Vec3{each_a, each_a, each_a}});
  }
  void idle(std::string_view phase, double duration_s) {
    for (double s = 0.0; s < duration_s; s += kStepS)
      steps_.push_back({phase, std::min(kStepS, duration_s - s), {}});
  }

  double max_a_;
  double sign_ = -1.0;
  std::vector<HeatingStep> steps_;
};

}  // namespace

std::vector<HeatingStep> heating_plan(double max_a) {
  constexpr std::array<std::string_view, 3> kBursts{"winding x", "winding y", "winding z"};
  Plan plan(max_a);
  plan.cool("at rest", 12.0, 3.0);
  plan.pulse("all windings, fan off", {1.0, 1.0, 1.0});
  plan.cool("all windings, fan off", 300.0, 10.0);
  for (int coil = 0; coil < 3; ++coil) {
    Vec3 direction;
    direction[coil] = 1.0;
    const std::string_view phase = kBursts[static_cast<std::size_t>(coil)];
    plan.heat(phase, direction, kBurstA, kBurstS);
    plan.cool(phase, 96.0, 6.0);
  }
  plan.heat("all windings", {1.0, 1.0, 1.0}, kHeatA, kHeatS);
  plan.heat("all windings", {1.0, 1.0, 1.0}, kSteadyA, kSteadyS);
  plan.cool("all windings", 600.0, 10.0);
  return plan.take();
}

double duration_s(const std::vector<HeatingStep>& plan) {
  return std::accumulate(
      plan.begin(), plan.end(), 0.0,
      [](double sum, const HeatingStep& step) { return sum + step.duration_s; });
}

}  // namespace hedgehog::model
