// SPDX-License-Identifier: MIT
// Experiments as files: JSON with comments, every key explained in config/study/*.json.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "clients/common/problem.h"
#include "clients/study/rules/experiment.h"

namespace hedgehog::study {

/// The files of config/study, built in.
struct Preset {
  std::string_view name;
  std::string_view text;
};
const std::vector<Preset>& presets();

/// EX_CONFIG with "file:line: key: reason" for each error. The text must contain the key `name`.
Result<Experiment> parse_experiment(std::string_view text, const std::string& file);

/// A preset by its name, or a file (a path with a slash or ending in .json; EX_NOINPUT if it cannot
/// be read).
Result<Experiment> find_experiment(const std::string& name_or_file);

/// EX_CONFIG if a preset has the same name and differs.
Result<void> is_no_other_preset(const Experiment& experiment);

/// In the format of `parse_experiment`, on one line, with every key.
std::string experiment_text(const Experiment& experiment);

}  // namespace hedgehog::study
