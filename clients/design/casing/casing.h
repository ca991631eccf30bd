// SPDX-License-Identifier: MIT
// The two printed halves that hold the magnets (thesis section 2.4, Fig. 2.1 and 2.2): with a
// cavity for each magnet, open to the inside; beyond a pin's cavity a smaller hole for the pin
// itself.
#pragma once

#include <string>
#include <vector>

#include "clients/common/problem.h"
#include "clients/design/input/design.h"
#include "model/magnets/magnet_array.h"
#include "model/vec3.h"

namespace hedgehog::design {

/// Travel of the pins, and thickness of the plastic beyond them: 35 + 10 + 1.5 + 3.5 mm are half of
/// the 10 cm of the thesis' ball. mm.
inline constexpr double kPinTravelMm = 1.5;
inline constexpr double kRoofMm = 3.5;
/// Diameter of the pin's hole, relative to that of its magnet.
inline constexpr double kPinHoleShare = 0.6;
/// Depth of the notch for the cables, at the fan's opening. mm.
inline constexpr double kCableMm = 3.0;

/// Default clearance around a magnet, and recommended minimum of a wall. mm.
inline constexpr double kUsualClearanceMm = 0.15;
inline constexpr double kMinWallMm = 0.2;
/// Line width of a common nozzle: thinner walls are left out by most printers, mm.
inline constexpr double kNozzleMm = 0.4;
/// PLA, g/mm^3.
inline constexpr double kPlasticGMm3 = 1.24e-3;

/// Outer radius of the ball, mm.
double outer_radius_mm(double sphere_mm, const Size& pin, const Size& shield) noexcept;

struct Casing {
  /// Radius of the inner faces of the magnets, which is the inner radius of the casing.
  double sphere_mm = 35.0;
  Size pin;
  Size shield;
  /// Directions from the centre.
  std::vector<model::Vec3> pins;
  std::vector<model::Vec3> shields;
  /// Around each magnet, so that it slides; depends on the printer.
  double clearance_mm = kUsualClearanceMm;
  /// Diameter of the fan's opening at the bottom, with a notch for its cables; 0: none.
  double fan_mm = 0.0;
  /// Number of sides of a cavity; the ball has four times as many round the equator.
  int facets = 16;
  /// Azimuths of the lower half's tabs in the upper one: unequal angles, so that the halves fit in
  /// one way only. Degrees from the front.
  std::vector<double> notches_deg;
};

/// With the default clearance and without an opening for the fan.
Casing casing_of(const Design& design, const model::Arrangement& array);

/// The largest of 0.15, 0.1 and 0.05 mm that leaves walls of `kMinWallMm`; 0.05 if none does.
double widest_clearance_mm(Casing casing, const model::Arrangement& array);

/// Volume of the plastic of both halves, printed solid, without tabs and the notch for the cables.
double volume_mm3(const Casing& casing) noexcept;

/// Distance of a cavity's corners from its axis: with the clearance at the corners, and with the
/// whole magnet between the sides. mm.
double cavity_reach_mm(const Casing& casing, const Size& magnet) noexcept;

/// The thinnest wall between the cavities of two magnets.
struct Wall {
  /// Below 0: they overlap.
  double mm = 0.0;
  /// "pin 0 and shield 0".
  std::string between;
};
Wall thinnest_wall(const Casing& casing, const model::Arrangement& array);

/// The three azimuths near 40, 150 and 265 degrees at which tabs are farthest from any pin's hole.
std::vector<double> notch_places(const Casing& casing);

/// The largest opening at the bottom, up to 34 mm across, that with its notch keeps a distance of
/// 1.5 mm from every cavity; 0 if that is less than 10 mm.
double widest_fan_mm(const Casing& casing);

/// The model for OpenSCAD; the variable `part` is "upper" or "lower". `heading`: comment lines at
/// the beginning, without "//".
std::string openscad_text(const Casing& casing, const std::vector<std::string>& heading);

/// Renders an STL of `part` with openscad, checks that it is closed, and returns its triangle
/// count.
Result<std::size_t> render_stl(const std::string& scad_path, const std::string& part,
                               const std::string& stl_path);

}  // namespace hedgehog::design
