// SPDX-License-Identifier: MIT
#include "clients/study/rules/experiment.h"

#include <algorithm>
#include <limits>

namespace hedgehog::study {

int StaircaseRule::total_reversals() const noexcept {
  std::int64_t total = 0;
  for (const Stage& stage : stages) total += stage.reversals;
  return static_cast<int>(std::min<std::int64_t>(total, std::numeric_limits<int>::max()));
}

int Experiment::decimals() const noexcept { return quantity == Quantity::kCurrentA ? 4 : 3; }

const char* Experiment::unit() const noexcept {
  return quantity == Quantity::kCurrentA ? "A" : "%";
}

Stimulus reference_stimulus(const Experiment& experiment) noexcept {
  return {experiment.pattern.current_a, experiment.pattern.speed_pins_s};
}

Stimulus test_stimulus(const Experiment& experiment, Level level) noexcept {
  Stimulus stimulus = reference_stimulus(experiment);
  const double value = to_value(level, experiment.decimals());
  switch (experiment.quantity) {
    case Quantity::kCurrentA:
      stimulus.current_a = value;
      break;
    case Quantity::kCurrentPercent:
      stimulus.current_a *= 1.0 + value / 100.0;
      break;
    case Quantity::kSpeedPercent:
      stimulus.speed_pins_s *= 1.0 + value / 100.0;
      break;
  }
  return stimulus;
}

}  // namespace hedgehog::study
