// SPDX-License-Identifier: MIT
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "clients/study/experiment_file.h"

namespace hedgehog::study {

namespace {

using nlohmann::json;

const char* name_of(Quantity quantity) {
  switch (quantity) {
    case Quantity::kCurrentPercent:
      return "current_percent";
    case Quantity::kSpeedPercent:
      return "speed_percent";
    case Quantity::kCurrentA:
      break;
  }
  return "current_a";
}

}  // namespace

Result<Experiment> find_experiment(const std::string& name_or_file) {
  for (const Preset& preset : presets())
    if (preset.name == name_or_file) return parse_experiment(preset.text, name_or_file);
  if (name_or_file.find('/') == std::string::npos && !name_or_file.ends_with(".json")) {
    std::string known;
    for (const Preset& preset : presets())
      known += (known.empty() ? "" : ", ") + std::string(preset.name);
    return Problem{EX_USAGE, "no experiment is called " + name_or_file + "; there are " + known +
                                 ", or name a file"};
  }
  std::ifstream file(name_or_file, std::ios::binary);
  if (!file || std::filesystem::is_directory(name_or_file))
    return Problem{EX_NOINPUT, name_or_file + ": cannot be read"};
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  return parse_experiment(text, name_or_file);
}

Result<void> is_no_other_preset(const Experiment& experiment) {
  for (const Preset& preset : presets()) {
    if (preset.name == experiment.name && find_experiment(experiment.name).value() != experiment) {
      return Problem{EX_CONFIG, experiment.name +
                                    " is the name of a preset that differs: give it " +
                                    "a name of its own"};
    }
  }
  return {};
}

std::string experiment_text(const Experiment& e) {
  const int decimals = e.decimals();
  json stages = json::array();
  for (const Stage& stage : e.rule.stages) {
    stages.push_back({{"step_up", to_value(stage.step_up, decimals)},
                      {"step_down", to_value(stage.step_down, decimals)},
                      {"reversals", stage.reversals}});
  }
  return json{{"name", e.name},
              {"task", e.task == Task::kYesNo ? "yes_no" : "two_intervals"},
              {"level", name_of(e.quantity)},
              {"question", e.question},
              {"start", to_value(e.rule.start, decimals)},
              {"floor", to_value(e.rule.floor, decimals)},
              {"ceiling", to_value(e.rule.ceiling, decimals)},
              {"stages", stages},
              {"positives_down", e.rule.positives_down},
              {"negatives_up", e.rule.negatives_up},
              {"quick_start", e.rule.quick_start},
              {"discard", e.rule.discard},
              {"max_trials", e.rule.max_trials},
              {"duration_ms", e.pattern.duration_ms},
              {"gap_ms", e.pattern.gap_ms},
              {"current_a", e.pattern.current_a},
              {"speed_pins_s", e.pattern.speed_pins_s},
              {"ring_deg", e.pattern.ring_deg},
              {"sense", e.pattern.clockwise ? "cw" : "ccw"},
              {"order", e.order == IntervalOrder::kRandom ? "random" : "balanced"},
              {"catch_one_in", e.catch_one_in},
              {"practice", e.practice},
              {"response_limit_ms", e.response_limit_ms},
              {"rest_every", e.rest_every}}
      .dump();
}

}  // namespace hedgehog::study
