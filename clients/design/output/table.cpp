// SPDX-License-Identifier: MIT
#include "clients/design/output/table.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>
#include <sstream>

#include "base/number_text.h"
#include "clients/lib/html.h"

namespace hedgehog::design {
namespace {

constexpr std::size_t kScreenWidth = 80;

/// Characters, not bytes: UTF-8 continuation bytes take no room.
std::size_t width_of(const std::string& text) {
  return static_cast<std::size_t>(std::count_if(
      text.begin(), text.end(),
      [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

std::string csv_cell(const std::string& cell) {
  if (cell.find_first_of(",\"\n") == std::string::npos) return cell;
  std::string quoted = "\"";
  for (const char c : cell) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

std::string csv_line(const std::vector<std::string>& cells) {
  std::string line;
  for (const std::string& cell : cells) line += (line.empty() ? "" : ",") + csv_cell(cell);
  return line + "\n";
}

}  // namespace

void Table::add(std::vector<std::string> cells) {
  assert(cells.size() == columns_.size());
  rows_.push_back(std::move(cells));
}

std::string Table::text() const {
  std::vector<std::size_t> widths;
  for (std::size_t c = 0; c < columns_.size(); ++c) {
    widths.push_back(width_of(columns_[c].title));
    for (const auto& row : rows_) widths[c] = std::max(widths[c], width_of(row[c]));
  }
  const std::size_t last_begins =
      std::accumulate(widths.begin(), widths.end() - 1, 2 * widths.size());
  const auto line = [&](auto cell_of) {
    std::string shown;
    for (std::size_t c = 0; c + 1 < columns_.size(); ++c) {
      const std::string cell = cell_of(c);
      const std::string blanks(widths[c] - width_of(cell), ' ');
      shown += "  " + (columns_[c].left ? cell + blanks : blanks + cell);
    }
    const std::string last = cell_of(columns_.size() - 1);
    if (columns_.back().left && last_begins + width_of(last) > kScreenWidth) {
      return shown + "  " + wrapped(last, kScreenWidth, last_begins).substr(last_begins);
    }
    shown +=
        "  " +
        (columns_.back().left ? last : std::string(widths.back() - width_of(last), ' ') + last);
    shown.erase(shown.find_last_not_of(' ') + 1);
    return shown + "\n";
  };
  std::string shown = line([&](std::size_t c) { return columns_[c].title; });
  for (const auto& row : rows_) shown += line([&](std::size_t c) { return row[c]; });
  return shown;
}

std::string Table::csv() const {
  std::vector<std::string> names;
  for (const Column& column : columns_) names.push_back(column.name);
  std::string shown = csv_line(names);
  for (const auto& row : rows_) shown += csv_line(row);
  return shown;
}

std::string Table::html() const {
  const auto cell = [&](const std::string& tag, std::size_t c, const std::string& text) {
    return "<" + tag + (columns_[c].left ? " class=\"l\">" : ">") + client::escape_html(text) +
           "</" + tag + ">";
  };
  std::string shown = "<table>\n<tr>";
  for (std::size_t c = 0; c < columns_.size(); ++c) shown += cell("th", c, columns_[c].title);
  shown += "</tr>\n";
  for (const auto& row : rows_) {
    shown += "<tr>";
    for (std::size_t c = 0; c < columns_.size(); ++c) shown += cell("td", c, row[c]);
    shown += "</tr>\n";
  }
  return shown + "</table>\n";
}

std::string fixed(double number, int digits) {
  return std::isfinite(number) ? base::fixed(number, digits) : "none";
}

std::string wrapped(const std::string& text, std::size_t width, std::size_t indent) {
  std::istringstream words(text);
  std::string lines;
  std::string line;
  const auto end_line = [&] {
    lines += std::string(indent, ' ') + line + "\n";
    line.clear();
  };
  for (std::string word; words >> word;) {
    if (!line.empty() && indent + width_of(line) + 1 + width_of(word) > width) end_line();
    line += (line.empty() ? "" : " ") + word;
  }
  if (!line.empty()) end_line();
  return lines;
}

}  // namespace hedgehog::design
