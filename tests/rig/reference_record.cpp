// SPDX-License-Identifier: MIT
#include "tests/rig/reference_record.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace hedgehog::rig {
namespace {

constexpr double kFigureTolerance = 1e-7;

bool same(double found, double expected) {
  if (std::isnan(expected) || std::isinf(expected))
    return found == expected || (std::isnan(found) && std::isnan(expected));
  return std::abs(found - expected) <= kFigureTolerance * std::max(1.0, std::abs(expected));
}

std::vector<std::string> fields(const std::string& line) {
  std::vector<std::string> found;
  std::istringstream in(line);
  for (std::string one; std::getline(in, one, '\t');) found.push_back(one);
  return found;
}

std::string text_of(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.10g", value);
  return text;
}

}  // namespace

void ReferenceRecord::add(const std::string& row, const Figures& figures) {
  std::vector<std::string> columns;
  std::vector<double> values;
  for (const auto& [name, value] : figures) {
    columns.push_back(name);
    values.push_back(value);
  }
  if (columns_.empty()) columns_ = columns;
  if (columns != columns_) throw std::logic_error("row " + row + " has other columns");
  rows_.emplace_back(row, values);
}

std::string ReferenceRecord::table() const {
  std::string text = "row";
  for (const std::string& column : columns_) text += '\t' + column;
  text += '\n';
  for (const auto& [name, values] : rows_) {
    text += name;
    for (const double value : values) text += '\t' + text_of(value);
    text += '\n';
  }
  return text;
}

std::string ReferenceRecord::differences(const std::string& path) const {
  if (std::getenv("HEDGEHOG_WRITE_REFERENCE") != nullptr) {
    std::ofstream(path) << table();
    return path + ": written, not compared\n";
  }
  std::ifstream in(path);
  std::string line;
  std::getline(in, line);
  std::vector<std::string> head = fields(line);
  if (head.empty()) return path + ": cannot be read\n";
  head.erase(head.begin());
  if (head != columns_) return path + ": has other columns\n";
  std::string found;
  for (const auto& [name, values] : rows_) {
    std::getline(in, line);
    const std::vector<std::string> expected = fields(line);
    if (expected.size() != values.size() + 1 || expected[0] != name)
      return found + path + ": row " + name + " is missing\n";
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (!same(values[i], std::stod(expected[i + 1])))
        found += name + ", " + columns_[i] + ": " + text_of(values[i]) + ", not " +
                 expected[i + 1] + "\n";
    }
  }
  if (std::getline(in, line)) found += path + ": has more rows\n";
  return found;
}

}  // namespace hedgehog::rig
