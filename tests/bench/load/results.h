// SPDX-License-Identifier: MIT
// Rounds as rows: medians, and the ratios of each round.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tests/bench/load/figures.h"
#include "tests/bench/load/rows.h"

namespace hedgehog::bench {

struct Range {
  double median = 0.0;
  double min = 0.0;
  double max = 0.0;
  /// nullopt: no values.
  static std::optional<Range> of(std::vector<double> values);
};

struct Result {
  Row row;
  std::optional<Range> value;
  std::optional<Range> reference;
  /// Value by reference, of each round that has both.
  std::optional<Range> ratio;
  /// nullopt: no goal, or not the figure that it is about.
  std::optional<bool> met;
  /// Why `value` or `reference` is not there, for those that this machine cannot have.
  std::string left_out;

  /// A figure that should be there is not.
  bool is_incomplete() const {
    return left_out.empty() && (!value || (!row.reference.empty() && !reference));
  }
};

std::vector<Result> results(const std::vector<Row>& rows, const std::vector<Figures>& rounds);

/// As people read it, of lines of 120 columns.
std::string table_of(const std::vector<Result>& results);
/// As programs do: `rounds` is how many there were.
std::string json_of(const std::vector<Result>& results, std::size_t rounds, double seconds);

}  // namespace hedgehog::bench
