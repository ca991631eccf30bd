// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "clients/study/experiment_file.h"

namespace hedgehog::study {

/// One of the shipped experiments, by name.
inline Experiment preset(const std::string& name) { return find_experiment(name).value(); }

}  // namespace hedgehog::study
