// SPDX-License-Identifier: MIT
#include "clients/design/input/design_flags.h"

#include <algorithm>
#include <regex>
#include <sstream>

#include "clients/design/input/design_file.h"

namespace hedgehog::design {
namespace {

Result<void> take_number(const std::optional<double>& typed, double min, double max,
                         const char* flag, const char* unit, double& out) {
  if (!typed) return {};
  if (!(*typed >= min && *typed <= max)) {
    return Problem{kUsage, std::string(flag) + ": " + to_text(*typed) + unit + " is outside " +
                               to_text(min) + " to " + to_text(max) + unit};
  }
  out = *typed;
  return {};
}

Result<void> take_size(const std::optional<std::string>& typed, const char* flag, Size& out) {
  if (!typed) return {};
  const auto size = parse_size(*typed, flag);
  if (!size) return size.error();
  out = *size;
  return {};
}

Result<void> take_ids(const std::optional<std::string>& typed, const char* flag,
                      std::vector<int>& out) {
  if (!typed) return {};
  auto ids = parse_ids(*typed, flag);
  if (!ids) return ids.error();
  out = std::move(*ids);
  return {};
}

Result<void> take_settings(const DesignFlags& flags, model::ForceSettings& out) {
  if (flags.model) {
    const auto known = model::force_model_named(*flags.model);
    if (!known)
      return Problem{kUsage, "--model: '" + *flags.model + "' is none of exact, hybrid, dipole"};
    out.model = *known;
  }
  if (!flags.accuracy) return {};
  if (!(*flags.accuracy >= model::kFinestAccuracy && *flags.accuracy <= model::kCoarsestAccuracy))
    return Problem{kUsage, "--accuracy: must be from 1e-10 to 0.1, a part of the force"};
  out.accuracy = *flags.accuracy;
  return {};
}

}  // namespace

Result<std::vector<int>> parse_ids(const std::string& text, const std::string& what) {
  static const std::regex kIds(R"((\d{1,5})(?:-(\d{1,5}))?)");
  std::vector<int> ids;
  if (text == "none") return ids;
  std::istringstream parts(text);
  for (std::string part; std::getline(parts, part, ',');) {
    std::smatch found;
    if (!std::regex_match(part, found, kIds))
      return Problem{kUsage, what + ": '" + part + "' is no id; ids are given as 3,7-9"};
    const int first = std::stoi(found[1]);
    const int last = found[2].matched ? std::stoi(found[2]) : first;
    if (last < first) return Problem{kUsage, what + ": '" + part + "' ends below where it begins"};
    for (int id = first; id <= last; ++id) ids.push_back(id);
  }
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  return ids;
}

Result<Design> design_from(const DesignFlags& flags) {
  Design design;
  if (!flags.file.empty()) {
    auto loaded = load_design(flags.file);
    if (!loaded) return loaded.error();
    design = std::move(*loaded);
  }
  if (flags.array && flags.positions)
    return Problem{kUsage, "--array and --positions: only one of them can be the array"};
  if (flags.array) {
    design.array = *flags.array;
    design.positions.clear();
  }
  if (flags.positions) design.positions = *flags.positions;
  for (const auto& taken :
       {take_size(flags.magnet, "--magnet", design.magnet),
        take_size(flags.shield, "--shield", design.shield),
        take_number(flags.sphere_mm, kMinSphereMm, kMaxSphereMm, "--sphere", " mm",
                    design.sphere_mm),
        take_number(flags.remanence_t, 0.01, 2, "--remanence", " T", design.remanence_t),
        take_number(flags.coil_force_n, 0.001, 100, "--coil-force", " N", design.coil_force_n),
        take_ids(flags.removed_pins, "--remove-pins", design.removed_pins),
        take_ids(flags.removed_shields, "--remove-shields", design.removed_shields),
        take_settings(flags, design.settings)})
    if (!taken) return taken.error();
  return design;
}

}  // namespace hedgehog::design
