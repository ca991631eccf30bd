// SPDX-License-Identifier: MIT
#include "clients/design/device_file.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <regex>
#include <utility>
#include <vector>

#include "base/number_text.h"
#include "model/magnets/arrangement.h"
#include "model/magnets/electromagnet.h"
#include "model/magnets/pin_curves.h"

namespace hedgehog::design {
namespace {

using Json = nlohmann::ordered_json;

/// The whole array that contains `design`, by its name in the daemon.
Result<model::Arrangement> known_array(const Design& design) {
  auto known = model::arrangement_named(design.array);
  if (!known) known = model::arrangement_named(design.array.substr(0, design.array.find('-')));
  if (!known) return Problem{kUsage, known.error().message};
  return *std::move(known);
}

/// The ids of the sites in `whole` that are missing in `left`.
std::vector<int> missing(const std::vector<model::MagnetSite>& whole,
                         const std::vector<model::MagnetSite>& left) {
  constexpr double kSameDirection = 1e-6;
  std::vector<int> ids;
  for (const model::MagnetSite& site : whole) {
    const bool there = std::any_of(left.begin(), left.end(), [&](const model::MagnetSite& other) {
      return model::norm(other.direction - site.direction) < kSameDirection;
    });
    if (!there) ids.push_back(site.id);
  }
  return ids;
}

/// A pin on the meridian of the casing's arrow: canonical arrays have one, a pentagon.
std::optional<int> front_pin(const model::Arrangement& whole) {
  constexpr double kOnMeridian = 1e-6;
  const auto front =
      std::find_if(whole.pins.begin(), whole.pins.end(), [](const model::MagnetSite& pin) {
        return pin.direction.x > kOnMeridian && std::abs(pin.direction.y) < kOnMeridian;
      });
  return front == whole.pins.end() ? std::nullopt : std::optional(front->id);
}

}  // namespace

Result<std::string> device_text(const Design& design, const std::string& name) {
  static const std::regex kName("[A-Za-z0-9_.-]{1,32}");
  if (!std::regex_match(name, kName)) {
    return Problem{
        kUsage,
        "--device: the file's name is the ball's: 1 to 32 letters, digits, '-', '_', '.'; not '" +
            name + "'"};
  }
  if (!design.positions.empty()) {
    return Problem{kBadData, "no device file for " + design.positions +
                                 ": hedgehogd knows the arrays by name only"};
  }
  const auto whole = known_array(design);
  if (!whole) return whole.error();
  const auto left = arrangement_of(design);
  if (!left) return left.error();
  if (const auto problem = model::check_fit(*left, design.sizes()))
    return Problem{kBadData, left->name + ": " + problem->message};
  // For the typical pin at its rest, as in the daemon.
  const double rest_mm = model::PinCurves(*left, design.sizes()).typical_rest_mm();
  const double slope_n_a = model::coil_force_n(model::measured_electromagnet(), 1.0,
                                               design.sizes().pin, design.sphere_mm, 0.0, rest_mm);
  const auto front = front_pin(*whole);
  if (!front) return Problem{kInternal, whole->name + " has no pin at the front"};
  // Bounds of the daemon's keys.
  if (slope_n_a < 0.001 || slope_n_a > 0.1 || design.sphere_mm < 5.0 || design.sphere_mm > 500.0 ||
      design.remanence_t < 0.1 || design.remanence_t > 2.0) {
    return Problem{kBadData, "no device file for " + to_text(design) +
                                 ": hedgehogd takes spheres of 5 to 500 mm, 0.1 to 2 T, and 0.001 "
                                 "to 0.1 N/A at a pin, of which these have " +
                                 base::shortest(std::round(slope_n_a * 1e6) / 1e6)};
  }
  Json root;
  root["name"] = name;
  root["model"] = "hedgehog-" + std::to_string(left->pins.size());
  root["arrangement"] = whole->name;
  root["removed_pins"] = missing(whole->pins, left->pins);
  root["removed_shields"] = missing(whole->shields, left->shields);
  root["front_pin"] = *front;
  root["pin_magnet_mm"] = {design.magnet.diameter_mm, design.magnet.height_mm};
  root["shield_magnet_mm"] = {design.shield.diameter_mm, design.shield.height_mm};
  root["remanence_t"] = design.remanence_t;
  root["sphere_mm"] = design.sphere_mm;
  root["force_slope_n_a"] = std::round(slope_n_a * 1e6) / 1e6;
  return "// " + to_text(design) + "; hedgehog-design " HEDGEHOG_VERSION +
         "\n// force_slope_n_a is what the thesis' electromagnet, as measured, makes of these "
         "magnets on the pin with the median rest. To be"
         "\n// measured on the ball: coil_matrix, r25_ohm, force_slope_n_a. What is not here is as "
         "on a hedgehog-86.\n" +
         root.dump(2) + "\n";
}

}  // namespace hedgehog::design
