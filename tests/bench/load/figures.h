// SPDX-License-Identifier: MIT
// What one round has measured.
#pragma once

#include <map>
#include <string>

namespace hedgehog::bench {

/// By names like "ping echo p50_us": scenario, what was measured, figure.
struct Figures {
  std::map<std::string, double> values;
  /// Why a figure that is wanted is not there, for those that this machine cannot have.
  std::map<std::string, std::string> left_out;

  double& operator[](const std::string& name) { return values[name]; }
};

}  // namespace hedgehog::bench
