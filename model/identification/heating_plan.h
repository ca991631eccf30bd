// SPDX-License-Identifier: MIT
// Current sequence that identifies the thermal network of a ball: each winding heated in turn, then
// all of them, then cooling with the fan and without it. The fan is controlled by the daemon.
#pragma once

#include <string_view>
#include <vector>

#include "model/vec3.h"

namespace hedgehog::model {

/// One constant current. Trivially copyable.
struct HeatingStep {
  /// Name of the phase for display. Heating and the cooling after it are one phase of consecutive
  /// steps.
  std::string_view phase;
  double duration_s = 0.0;
  /// Winding currents, A, signed.
  Vec3 current_a;
};

/// About 31 minutes. The norm of no current is above `max_a`.
std::vector<HeatingStep> heating_plan(double max_a = 15.0);

double duration_s(const std::vector<HeatingStep>& plan);

}  // namespace hedgehog::model
