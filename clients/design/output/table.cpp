// SPDX-License-Identifier: MIT
#include "clients/design/output/table.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>

#include "clients/common/csv.h"
#include "clients/common/html.h"
#include "clients/common/text.h"

namespace hedgehog::design {
namespace {

constexpr std::size_t kScreenWidth = 80;

}  // namespace

void Table::add(std::vector<std::string> cells) {
  assert(cells.size() == columns_.size());
  rows_.push_back(std::move(cells));
}

std::string Table::text() const {
  std::vector<std::size_t> widths;
  for (std::size_t c = 0; c < columns_.size(); ++c) {
    widths.push_back(client::columns(columns_[c].title));
    for (const auto& row : rows_) widths[c] = std::max(widths[c], client::columns(row[c]));
  }
  const std::size_t last_begins =
      std::accumulate(widths.begin(), widths.end() - 1, 2 * widths.size());
  const auto line = [&](auto cell_of) {
    std::string shown;
    for (std::size_t c = 0; c + 1 < columns_.size(); ++c) {
      const std::string cell = cell_of(c);
      shown += "  " +
               (columns_[c].left ? client::left(cell, widths[c]) : client::right(cell, widths[c]));
    }
    const std::string last = cell_of(columns_.size() - 1);
    if (columns_.back().left && last_begins + client::columns(last) > kScreenWidth) {
      return shown + "  " + client::wrapped(last, kScreenWidth, last_begins).substr(last_begins);
    }
    shown += "  " + (columns_.back().left ? last : client::right(last, widths.back()));
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
  std::string shown = client::csv_line(names) + "\n";
  for (const auto& row : rows_) shown += client::csv_line(row) + "\n";
  return shown;
}

std::string Table::html() const {
  const auto cell = [&](const std::string& tag, std::size_t c, const std::string& text) {
    return "<" + tag + (columns_[c].left ? " class=\"l\">" : ">") + client::escape_html(text) +
           "</" + tag + ">";
  };
  std::string shown = "<div class=\"wide\"><table>\n<tr>";
  for (std::size_t c = 0; c < columns_.size(); ++c) shown += cell("th", c, columns_[c].title);
  shown += "</tr>\n";
  for (const auto& row : rows_) {
    shown += "<tr>";
    for (std::size_t c = 0; c < columns_.size(); ++c) shown += cell("td", c, row[c]);
    shown += "</tr>\n";
  }
  return shown + "</table></div>\n";
}

std::string fixed(double number, int digits) {
  return std::isfinite(number) ? client::fixed(number, digits) : "none";
}

}  // namespace hedgehog::design
