// SPDX-License-Identifier: MIT
// Tables for users (aligned), for programs (CSV) and for the report (HTML).
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace hedgehog::design {

class Table {
 public:
  struct Column {
    /// Header on the screen: "rest mm".
    std::string title;
    /// Header in CSV, with the unit at the end: "rest_mm".
    std::string name;
    bool left = false;
  };

  explicit Table(std::vector<Column> columns) : columns_(std::move(columns)) {}

  /// REQUIRES: as many cells as columns.
  void add(std::vector<std::string> cells);
  const std::vector<std::vector<std::string>>& rows() const noexcept { return rows_; }

  /// Two blanks before and between columns; each line ends in a line feed. A left-aligned last
  /// column is wrapped where it exceeds 80 columns.
  std::string text() const;
  /// RFC 4180, with a line feed as line end.
  std::string csv() const;
  /// In a box of the class `wide`, which scrolls if the page is narrower.
  std::string html() const;

 private:
  std::vector<Column> columns_;
  std::vector<std::vector<std::string>> rows_;
};

/// NaN for nullopt: `fixed` then writes "none", JSON null.
inline double or_none(const std::optional<double>& number) {
  return number.value_or(std::numeric_limits<double>::quiet_NaN());
}

/// "%.3f", and "none" for NaN.
std::string fixed(double number, int digits);

}  // namespace hedgehog::design
