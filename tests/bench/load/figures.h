// SPDX-License-Identifier: MIT
// Measurements of one round.
#pragma once

#include <map>
#include <string>

namespace hedgehog::bench {

/// Keyed by names like "ping echo p50_us": scenario, measured program, figure.
struct Figures {
  std::map<std::string, double> values;
  /// Reason for each requested figure that this machine cannot provide.
  std::map<std::string, std::string> left_out;

  double& operator[](const std::string& name) { return values[name]; }
};

}  // namespace hedgehog::bench
