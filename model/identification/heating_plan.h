// SPDX-License-Identifier: MIT
// Current sequence that identifies a ball's thermal network. The daemon controls the fan.
#pragma once

#include <string_view>
#include <vector>

#include "model/vec3.h"

namespace hedgehog::model {

/// One constant current. Trivially copyable.
struct HeatingStep {
  std::string_view phase;  // for display; heating and the cooling after it are one phase
  double duration_s = 0.0;
  Vec3 current_a;  // of the windings, signed
};

/// About 31 minutes. The norm of no current is above `max_a`.
std::vector<HeatingStep> heating_plan(double max_a = 15.0);

double duration_s(const std::vector<HeatingStep>& plan);

}  // namespace hedgehog::model
