// SPDX-License-Identifier: MIT
#include "clients/design/input/design_file.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>

#include "base/parse_json.h"
#include "clients/design/output/tool.h"

namespace hedgehog::design {
namespace {

using Json = nlohmann::ordered_json;

/// Stores a value in the design; returns the error, or empty.
using Reader = std::function<std::string(const Json&, Design&)>;

Reader text_key(std::string Design::*member) {
  return [member](const Json& value, Design& design) -> std::string {
    if (!value.is_string()) return "must be a text";
    design.*member = value.get<std::string>();
    return "";
  };
}

Reader size_key(Size Design::*member) {
  return [member](const Json& value, Design& design) -> std::string {
    if (!value.is_string()) return "must be a text such as \"8x10\"";
    const auto size = parse_size(value.get<std::string>(), "");
    if (!size) return size.error().message.substr(2);
    design.*member = *size;
    return "";
  };
}

Reader number_key(double Design::*member, double min, double max) {
  return [member, min, max](const Json& value, Design& design) -> std::string {
    const double number = value.is_number() ? value.get<double>() : std::nan("");
    if (!(number >= min && number <= max))
      return "must be a number from " + to_text(min) + " to " + to_text(max);
    design.*member = number;
    return "";
  };
}

Reader ids_key(std::vector<int> Design::*member) {
  return [member](const Json& value, Design& design) -> std::string {
    std::vector<int> ids;
    for (const Json& id : value.is_array() ? value : Json::array({nullptr})) {
      if (!id.is_number_unsigned() || id > 100000) return "must be a list of ids";
      ids.push_back(id.get<int>());
    }
    std::sort(ids.begin(), ids.end());
    ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
    design.*member = ids;
    return "";
  };
}

const std::map<std::string, Reader>& keys() {
  static const std::map<std::string, Reader> kKeys{
      {"array", text_key(&Design::array)},
      {"positions", text_key(&Design::positions)},
      {"magnet", size_key(&Design::magnet)},
      {"shield", size_key(&Design::shield)},
      {"sphere_mm", number_key(&Design::sphere_mm, kMinSphereMm, kMaxSphereMm)},
      {"remanence_t", number_key(&Design::remanence_t, 0.01, 2)},
      {"removed_pins", ids_key(&Design::removed_pins)},
      {"removed_shields", ids_key(&Design::removed_shields)},
      {"coil_force_n", number_key(&Design::coil_force_n, 0.001, 100)},
      {"made_by", [](const Json&, Design&) { return std::string(); }},
  };
  return kKeys;
}

}  // namespace

Result<Design> parse_design(const std::string& text, const std::string& name) {
  const auto parsed = base::parse_json<Json>(text, base::JsonComments::kAllowed);
  if (!parsed.good()) return Problem{kBadData, name + " is no design file: " + parsed.problem};
  const Json& root = parsed.value;
  if (!root.is_object()) return Problem{kBadData, name + " is no design file: not a JSON object"};
  Design design;
  for (const auto& [key, value] : root.items()) {
    const auto reader = keys().find(key);
    if (reader == keys().end()) {
      std::string known;
      for (const auto& entry : keys()) known += (known.empty() ? "" : ", ") + entry.first;
      return Problem{kBadData, name + ": unknown key '" + key + "'; there are " + known};
    }
    const std::string wrong = reader->second(value, design);
    if (!wrong.empty()) return Problem{kBadData, name + ": " + key + ": " + wrong};
  }
  return design;
}

Result<Design> load_design(const std::string& path) {
  const auto text = read_file(path);
  if (!text) return text.error();
  auto design = parse_design(*text, path);
  if (!design) return design.error();
  // A nonexistent array or id is an error in the file, not on the command line.
  const auto array = arrangement_of(*design);
  if (!array && array.error().exit_code == kUsage)
    return Problem{kBadData, path + ": " + array.error().message};
  return design;
}

Result<void> protect_design(const std::string& path) {
  const auto text = read_file(path);
  if (!text || !parse_design(*text, path)) return {};
  return Problem{
      kUsage,
      path + " is a design file and is not written over; the design comes first, as in: export " +
          path + " --json"};
}

std::string design_text(const Design& design) {
  Json root;
  root["array"] = design.array;
  if (!design.positions.empty()) root["positions"] = design.positions;
  root["magnet"] = to_text(design.magnet);
  root["shield"] = to_text(design.shield);
  root["sphere_mm"] = design.sphere_mm;
  root["remanence_t"] = design.remanence_t;
  root["removed_pins"] = design.removed_pins;
  root["removed_shields"] = design.removed_shields;
  root["coil_force_n"] = design.coil_force_n;
  root["made_by"] = "hedgehog-design " HEDGEHOG_VERSION;
  return root.dump(2) + "\n";
}

}  // namespace hedgehog::design
