// SPDX-License-Identifier: MIT
// Results of a calculation without an independent reference, against a file in the repository: a
// table of named rows and columns. Every constant of the calculation affects some of them, so that
// none can change unnoticed.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace hedgehog::rig {

class ReferenceRecord {
 public:
  /// A row's values by the names of their columns, the same names in each row.
  using Figures = std::vector<std::pair<std::string, double>>;

  void add(const std::string& row, const Figures& figures);

  /// Compares with the table in `path`. Every difference of more than 1e-7 of the value (of 1,
  /// where it is smaller), a line each; empty: none. With HEDGEHOG_WRITE_REFERENCE=1 writes the
  /// table instead.
  std::string differences(const std::string& path) const;

 private:
  std::string table() const;

  std::vector<std::string> columns_;
  std::vector<std::pair<std::string, std::vector<double>>> rows_;
};

}  // namespace hedgehog::rig
