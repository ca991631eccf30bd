// SPDX-License-Identifier: MIT
// Rows and columns, for people (aligned), for programs (CSV) and for the report (HTML).
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
    /// Over the column on the screen: "rest mm".
    std::string title;
    /// In CSV, unit at the end: "rest_mm".
    std::string name;
    bool left = false;
  };

  explicit Table(std::vector<Column> columns) : columns_(std::move(columns)) {}

  /// REQUIRES: as many cells as columns.
  void add(std::vector<std::string> cells);
  const std::vector<std::vector<std::string>>& rows() const noexcept { return rows_; }

  /// Two blanks in front and between; each line ends in "\n". A last column on the left goes on in
  /// further lines where it would not fit into 80 columns.
  std::string text() const;
  /// RFC 4180, "\n" at the ends.
  std::string csv() const;
  /// In a box of the class `wide`, which scrolls where the page is narrower.
  std::string html() const;

 private:
  std::vector<Column> columns_;
  std::vector<std::vector<std::string>> rows_;
};

/// NaN where there is no number: `fixed` writes "none" then, JSON null.
inline double or_none(const std::optional<double>& number) {
  return number.value_or(std::numeric_limits<double>::quiet_NaN());
}

/// "%.3f", and "none" for a number that there is not (NaN).
std::string fixed(double number, int digits);

}  // namespace hedgehog::design
