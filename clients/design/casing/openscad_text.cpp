// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>

#include "clients/design/casing/casing.h"
#include "model/units.h"

namespace hedgehog::design {
namespace {

std::string list_of(const std::vector<model::Vec3>& directions) {
  std::string text;
  for (const model::Vec3& d : directions) {
    const double polar = std::acos(std::clamp(d.z, -1.0, 1.0)) / model::kRadiansPerDegree;
    const double azimuth = std::atan2(d.y, d.x) / model::kRadiansPerDegree;
    text += fmt::format("  [{:.5f}, {:.5f}],\n", polar, azimuth);
  }
  return "[\n" + text + "];\n";
}

std::string list_of(const std::vector<double>& numbers) {
  std::string text;
  for (const double number : numbers) text += (text.empty() ? "" : ", ") + to_text(number);
  return "[" + text + "];\n";
}

// The model after the parameters. Cavities are circumscribed polygons, so that magnets fit.
constexpr const char* kModules = R"(
inside = 1;  // cavities begin so far inside the sphere, so that nothing is left over their mouths
reach = max(sphere + pin_height + travel, sphere + shield_height) + roof;  // radius of the ball
ball_facets = 4 * facets;
notch_radius = reach - roof / 2;
hole = pin_hole / 2 / cos(180 / facets);

// Corners of a cavity: the clearance is there, and between them the whole magnet fits.
function around(d) = max(d / 2 + clearance, d / 2 / cos(180 / facets));

// A place is [angle from the top, azimuth from the front].
module at(place) rotate([0, place[0], place[1]]) children();

module shell(top) rotate_extrude($fn = ball_facets) difference() {
  intersection() {
    circle(r = reach, $fn = ball_facets);
    translate([0, top ? 0 : -2 * reach]) square(2 * reach);
  }
  circle(r = sphere, $fn = ball_facets);
}

// The pin's magnet moves up to the step; the pin on it goes through the narrow part.
module pin_cavity() rotate_extrude($fn = facets) polygon([
  [0, sphere - inside], [around(pin_diameter), sphere - inside],
  [around(pin_diameter), sphere + pin_height + travel],
  [hole, sphere + pin_height + travel], [hole, reach + 2], [0, reach + 2]]);

module shield_cavity() translate([0, 0, sphere - inside])
  cylinder(r = around(shield_diameter), h = shield_height + inside, $fn = facets);

module cavities(top) {
  for (p = pins) if (top ? p[0] < 90 + margin : p[0] > 90 - margin) at(p) pin_cavity();
  for (s = shields) if (top ? s[0] < 90 + margin : s[0] > 90 - margin) at(s) shield_cavity();
}
margin = 20;  // degrees beyond the equator in which a cavity can still reach into this half

// Tabs of the lower half in slots of the upper one.
module notches(play) for (azimuth = notches) rotate([0, 0, azimuth])
  translate([notch_radius, 0, 0])
    cube([1.6 + 2 * play, 5 + 2 * play, 2 * (3 + play)], center = true);

module fan_opening() if (fan > 0) {
  translate([0, 0, -2 * reach]) cylinder(d = fan, h = 2 * reach, $fn = 3 * facets);
  // For the cables, beside it, opposite the front.
  translate([-fan / 2 - cable, -3, -2 * reach]) cube([fan / 2 + cable, 6, 2 * reach]);
}

// An arrow that points up, engraved at the front.
module front_mark() at([82, 0]) translate([0, 0, reach - 0.8]) rotate(180)
  linear_extrude(2) polygon([[3, 0], [-2, 2.5], [-2, -2.5]]);

module upper() difference() {
  shell(true);
  notches(0.2);
  cavities(true);
  front_mark();
}

module lower() difference() {
  union() {
    shell(false);
    notches(0);
  }
  cavities(false);
  fan_opening();
}

if (part == "upper") upper();
else if (part == "lower") lower();
else {
  upper();
  lower();
}
)";

}  // namespace

std::string openscad_text(const Casing& casing, const std::vector<std::string>& heading) {
  std::ostringstream out;
  for (const std::string& line : heading) out << "// " << line << "\n";
  const auto number = [&out](const char* name, double value, const char* what) {
    out << name << " = " << to_text(value) << ";  // " << what << "\n";
  };
  out << "// Millimetres. z points up, x to the front.\n\n"
      << "part = \"both\";  // or \"upper\", \"lower\": openscad -D 'part=\"upper\"' -o "
         "upper.stl\n\n";
  number("sphere", casing.sphere_mm, "radius on which the magnets' inner faces lie");
  number("pin_diameter", casing.pin.diameter_mm, "of the magnet");
  number("pin_height", casing.pin.height_mm, "of the magnet");
  number("pin_hole", kPinHoleShare * casing.pin.diameter_mm,
         "for the pin that is glued on its magnet");
  number("shield_diameter", casing.shield.diameter_mm, "of the magnet");
  number("shield_height", casing.shield.height_mm, "of the magnet");
  number("travel", kPinTravelMm, "how far a pin can move out");
  number("roof", kRoofMm, "plastic over the magnets");
  number("clearance", casing.clearance_mm, "around each magnet");
  number("fan", casing.fan_mm, "diameter of the opening at the bottom; 0: none");
  number("cable", kCableMm, "depth of the cables' notch beside the fan");
  number("facets", casing.facets, "sides of a cavity; more are rounder and take longer");
  out << "notches = " << list_of(casing.notches_deg);
  out << "pins = " << list_of(casing.pins);
  out << "shields = " << list_of(casing.shields);
  out << kModules;
  return out.str();
}

}  // namespace hedgehog::design
