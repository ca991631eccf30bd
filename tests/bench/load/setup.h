// SPDX-License-Identifier: MIT
// Which programs are measured, and for how long.
#pragma once

#include <cstddef>
#include <string>

namespace hedgehog::bench {

struct Setup {
  /// Build folder of the measured programs.
  std::string build;
  /// Build folder of the reference programs.
  std::string reference;
  /// False: only the daemon and its own programs are measured.
  bool with_references = true;
  /// Duration of one measurement.
  double seconds = 1.0;
  std::size_t subscribers = 1000;
  /// References are measured first in even rounds, last in odd ones.
  int round = 0;

  std::string daemon() const { return build + "/daemon/hedgehogd"; }
  std::string reference_program(const std::string& name) const {
    return reference + "/tests/bench/reference_" + name;
  }
  std::string measured_program(const std::string& name) const {
    return build + "/tests/bench/" + name;
  }
};

}  // namespace hedgehog::bench
