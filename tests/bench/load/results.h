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
  /// nullopt if there are no values.
  static std::optional<Range> of(std::vector<double> values);
};

struct Result {
  Row row;
  std::optional<Range> value;
  std::optional<Range> reference;
  /// Ratio of value to reference, of each round that has both.
  std::optional<Range> ratio;
  /// nullopt: no goal, or the goal is for another figure.
  std::optional<bool> is_met;
  /// Why `value` or `reference` is missing, for those that this machine cannot provide.
  std::string left_out;

  /// True if a figure is missing that this machine can provide.
  bool is_incomplete() const {
    return left_out.empty() && (!value || (!row.reference.empty() && !reference));
  }
};

std::vector<Result> results(const std::vector<Row>& rows, const std::vector<Figures>& rounds);

/// Text table of at most 120 columns.
std::string table_of(const std::vector<Result>& results);
/// What was measured, when and where.
struct Run {
  std::size_t rounds = 0;
  double seconds = 0.0;  // of one measurement
  std::string commit;
  std::string date;     // RFC 3339
  std::string machine;  // kernel and processors
  /// Folder with the JSON of Google Benchmark, a file for each program; others are ignored. Empty:
  /// none.
  std::string functions;
};

std::string json_of(const std::vector<Result>& results, const Run& run);

}  // namespace hedgehog::bench
