// SPDX-License-Identifier: MIT
#include "clients/design/device_file.h"

#include <cmath>
#include <nlohmann/json.hpp>
#include <regex>

#include "model/magnets/electromagnet.h"

namespace hedgehog::design {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kDrivenArray = "tkD-86";

}  // namespace

Result<std::string> device_text(const Design& design, const std::string& name) {
  static const std::regex kName("[A-Za-z0-9_.-]{1,32}");
  if (!std::regex_match(name, kName)) {
    return Problem{
        kUsage,
        "--device: the file's name is the ball's: 1 to 32 letters, digits, '-', '_', '.'; not '" +
            name + "'"};
  }
  if (design.array != kDrivenArray || !design.whole()) {
    return Problem{kBadData, "no device file for " +
                                 (design.positions.empty() ? design.array : design.positions) +
                                 (design.removed_pins.empty() ? "" : " with pins removed") +
                                 (design.removed_shields.empty() ? "" : " with shields removed") +
                                 ": hedgehogd knows the places of tkD-86 only"};
  }
  if (!has_thesis_magnets(design)) {
    return Problem{kBadData, "no device file for " + to_text(design) +
                                 ": hedgehogd has the force curves of N45 pins 8x10 and shields "
                                 "4x10 on a sphere of 35 mm only, and would tell wrong places"};
  }
  const double slope_n_a = model::coil_force_n(model::measured_electromagnet(), 1.0,
                                               design.sizes().pin, design.sphere_mm, 0.0, 0.0);
  Json root;
  root["name"] = name;
  root["model"] = "hedgehog-86";
  root["arrangement"] = kDrivenArray;
  root["front_pin"] = 1;
  root["force_slope_n_a"] = std::round(slope_n_a * 1e6) / 1e6;
  return "// " + to_text(design) + "; hedgehog-design " HEDGEHOG_VERSION +
         "\n// force_slope_n_a is what the thesis' electromagnet, as measured, makes of these "
         "magnets. To be"
         "\n// measured on the ball: coil_matrix, r25_ohm, force_slope_n_a. What is not here is as "
         "on a hedgehog-86.\n" +
         root.dump(2) + "\n";
}

}  // namespace hedgehog::design
