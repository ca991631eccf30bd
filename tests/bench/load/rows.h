// SPDX-License-Identifier: MIT
// The rows of the table: which figure is compared with which, and the goal.
#pragma once

#include <string>
#include <vector>

namespace hedgehog::bench {

struct Goal {
  enum class Of { kNothing, kValue, kRatio };
  Of of = Of::kNothing;
  bool at_most = true;
  double bound = 0.0;

  std::string text() const;
  bool is_met_by(double figure) const { return at_most ? figure <= bound : figure >= bound; }
};

struct Row {
  std::string name;
  std::string unit;
  /// Names of figures.
  std::string value;
  std::string reference;  // empty: none
  std::string reference_name;
  Goal goal;
};

/// The rows of `make bench`.
std::vector<Row> reference_rows();

/// The rows of `make bench-compare`: the references are the same figures of another revision,
/// prefixed with `kOther`.
inline constexpr const char* kOther = "other ";
std::vector<Row> comparison_rows(const std::string& revision);

}  // namespace hedgehog::bench
