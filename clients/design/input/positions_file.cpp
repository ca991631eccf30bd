// SPDX-License-Identifier: MIT
#include "clients/design/input/positions_file.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <set>
#include <sstream>
#include <string_view>

#include "clients/design/input/number.h"
#include "clients/design/output/table.h"
#include "clients/design/output/tool.h"
#include "model/units.h"

namespace hedgehog::design {
namespace {

using model::Vec3;

// Written by spreadsheets at the beginning of a file.
constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

std::string trimmed(std::string text) {
  const auto blank = " \t\r\"";
  text.erase(0, text.find_first_not_of(blank));
  text.erase(text.find_last_not_of(blank) + 1);
  return text;
}

std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells;
  std::istringstream parts(line);
  for (std::string cell; std::getline(parts, cell, ',');) cells.push_back(trimmed(cell));
  return cells;
}

struct Columns {
  std::size_t kind = 0;
  std::size_t x = 0;
  std::size_t y = 0;
  std::size_t z = 0;
  std::optional<std::size_t> id;

  std::size_t last() const { return std::max({kind, x, y, z, id.value_or(0)}); }
};

std::optional<Columns> columns_of(const std::vector<std::string>& head) {
  const auto find = [&head](const std::string& name) -> std::optional<std::size_t> {
    for (std::size_t i = 0; i < head.size(); ++i)
      if (head[i] == name || head[i] == name + "_mm") return i;
    return {};
  };
  const auto kind = find("kind");
  const auto x = find("x");
  const auto y = find("y");
  const auto z = find("z");
  if (!kind || !x || !y || !z) return {};
  return Columns{*kind, *x, *y, *z, find("id")};
}

/// 0 at the poles, where it is undefined.
double azimuth_deg(const Vec3& direction) {
  const bool on_axis = std::hypot(direction.x, direction.y) < 1e-9;
  return on_axis ? 0.0 : std::atan2(direction.y, direction.x) / model::kRadiansPerDegree;
}

class PositionsReader {
 public:
  explicit PositionsReader(std::string name) : name_(std::move(name)) { array_.name = name_; }

  std::optional<Problem> read(const std::string& line, const Columns& columns, int number) {
    const auto wrong = [&](const std::string& reason) {
      return Problem{kBadData, name_ + ":" + std::to_string(number) + ": " + reason};
    };
    const std::vector<std::string> cells = cells_of(line);
    if (cells.size() <= columns.last()) return wrong("has fewer columns than the first line");
    const std::string& kind = cells[columns.kind];
    if (kind != "pin" && kind != "shield") return wrong("'" + kind + "' is neither pin nor shield");
    const auto x = parse_number<double>(cells[columns.x]);
    const auto y = parse_number<double>(cells[columns.y]);
    const auto z = parse_number<double>(cells[columns.z]);
    if (!x || !y || !z) return wrong("x, y and z must be numbers");
    const Vec3 place{*x, *y, *z};
    if (!model::is_finite(place) || model::norm(place) < 1e-9)
      return wrong("x, y and z are no direction from the centre");
    auto& sites = kind == "pin" ? array_.pins : array_.shields;
    auto& ids = kind == "pin" ? pin_ids_ : shield_ids_;
    const auto id =
        columns.id ? parse_number<int>(cells[*columns.id]) : static_cast<int>(sites.size());
    if (!id || *id < 0)
      return wrong("'" + cells[*columns.id] + "' is no id: a whole number from 0 up");
    if (!ids.insert(*id).second)
      return wrong(kind + " " + std::to_string(*id) + " was there before");
    sites.push_back({*id, model::unit_or(place, {0, 0, 1})});
    return {};
  }

  const model::Arrangement& array() const { return array_; }

 private:
  std::string name_;
  model::Arrangement array_;
  std::set<int> pin_ids_;
  std::set<int> shield_ids_;
};

}  // namespace

Result<model::Arrangement> parse_positions(const std::string& text, const std::string& name) {
  const std::string shape = name +
                            " is no CSV of positions: its first line must name the columns kind, "
                            "x, y, z, with commas between";
  std::istringstream lines(text);
  std::string line;
  if (!std::getline(lines, line)) return Problem{kBadData, name + " is empty"};
  if (line.starts_with(kByteOrderMark)) line.erase(0, kByteOrderMark.size());
  const auto columns = columns_of(cells_of(line));
  if (!columns) return Problem{kBadData, shape};
  PositionsReader reader(name);
  for (int number = 2; std::getline(lines, line); ++number) {
    if (trimmed(line).empty()) continue;
    if (const auto wrong = reader.read(line, *columns, number)) return *wrong;
  }
  if (reader.array().pins.empty()) return Problem{kBadData, name + " has no pins"};
  return reader.array();
}

Result<model::Arrangement> read_positions(const std::string& path) {
  const auto text = read_file(path);
  if (!text) return text.error();
  return parse_positions(*text, path);
}

std::string positions_csv(const model::Arrangement& arrangement, const model::ArraySizes& sizes) {
  Table table({{"kind", "kind", true},
               {"id", "id"},
               {"x", "x_mm"},
               {"y", "y_mm"},
               {"z", "z_mm"},
               {"azimuth", "azimuth_deg"},
               {"elevation", "elevation_deg"},
               {"diameter", "diameter_mm"},
               {"height", "height_mm"}});
  const auto add = [&](const char* kind, const model::MagnetSite& site,
                       const model::CylinderMagnet& magnet) {
    const Vec3 place = sizes.sphere_radius_mm * site.direction;
    table.add(
        {kind, std::to_string(site.id), fixed(place.x, 6), fixed(place.y, 6), fixed(place.z, 6),
         fixed(azimuth_deg(site.direction), 4),
         fixed(std::asin(std::clamp(site.direction.z, -1.0, 1.0)) / model::kRadiansPerDegree, 4),
         fixed(magnet.diameter_mm, 3), fixed(magnet.height_mm, 3)});
  };
  for (const auto& site : arrangement.pins) add("pin", site, sizes.pin);
  for (const auto& site : arrangement.shields) add("shield", site, sizes.shield);
  return table.csv();
}

}  // namespace hedgehog::design
