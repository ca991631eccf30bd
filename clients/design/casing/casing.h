// SPDX-License-Identifier: MIT
// The two printed halves that hold the magnets (thesis section 2.4, Fig. 2.1 and 2.2): from inside,
// a cavity for each magnet; behind a pin's cavity a smaller hole for the pin itself.
#pragma once

#include <string>
#include <vector>

#include "clients/common/problem.h"
#include "clients/design/input/design.h"
#include "model/magnets/magnet_array.h"
#include "model/vec3.h"

namespace hedgehog::design {

/// How far pins can move, and the plastic over them: 35 + 10 + 1.5 + 3.5 mm are the 10 cm of the
/// thesis' ball. mm.
inline constexpr double kPinTravelMm = 1.5;
inline constexpr double kRoofMm = 3.5;
/// Of a magnet's diameter: the hole for the pin on it.
inline constexpr double kPinHoleShare = 0.6;
/// Depth of the notch for the cables, beside the fan's opening. mm.
inline constexpr double kCableMm = 3.0;

/// Play around a magnet when nothing else is asked, and what a wall should have at least. mm.
inline constexpr double kUsualClearanceMm = 0.15;
inline constexpr double kMinWallMm = 0.2;
/// One line of a common nozzle: a wall below is left out by most printers, mm.
inline constexpr double kNozzleMm = 0.4;
/// PLA, g/mm^3.
inline constexpr double kPlasticGMm3 = 1.24e-3;

/// Radius of the finished ball, mm.
double outer_radius_mm(double sphere_mm, const Size& pin, const Size& shield) noexcept;

struct Casing {
  /// Where the inner faces of the magnets are, and the inside of the casing.
  double sphere_mm = 35.0;
  Size pin;
  Size shield;
  /// Directions from the centre.
  std::vector<model::Vec3> pins;
  std::vector<model::Vec3> shields;
  /// Around each magnet, so that it slides; printers differ.
  double clearance_mm = kUsualClearanceMm;
  /// The opening at the bottom for the fan, and its cables' notch beside it; 0: none.
  double fan_mm = 0.0;
  /// Sides of a cavity; the ball has four times as many round the equator.
  int facets = 16;
  /// Where the tabs of the lower half go into the upper one: unequal angles, so that the halves fit
  /// in one way only. Degrees from the front.
  std::vector<double> notches_deg;
};

/// With the usual clearance and without an opening for the fan.
Casing casing_of(const Design& design, const model::Arrangement& array);

/// The largest of 0.15, 0.1 and 0.05 mm that leaves walls of `kMinWallMm`; 0.05 when none does.
double widest_clearance_mm(Casing casing, const model::Arrangement& array);

/// The plastic of both halves, printed solid, without tabs and the notch for the cables.
double volume_mm3(const Casing& casing) noexcept;

/// How far a cavity's corners are from its axis: the clearance at the corners, and the whole magnet
/// between the sides. mm.
double cavity_reach_mm(const Casing& casing, const Size& magnet) noexcept;

/// The least plastic between the cavities of two magnets.
struct Wall {
  /// Below 0: they run into each other.
  double mm = 0.0;
  /// "pin 0 and shield 0".
  std::string between;
};
Wall thinnest_wall(const Casing& casing, const model::Arrangement& array);

/// The three places near 40, 150 and 265 degrees where tabs are farthest from any pin's hole.
std::vector<double> notch_places(const Casing& casing);

/// The largest opening at the bottom, up to 34 mm across, that stays with its notch 1.5 mm away
/// from every cavity; 0 when that is less than 10 mm.
double widest_fan_mm(const Casing& casing);

/// The model for OpenSCAD; the variable `part` is "upper" or "lower". `heading`: comment lines for
/// its first lines, without "//".
std::string openscad_text(const Casing& casing, const std::vector<std::string>& heading);

/// Lets openscad make an STL of `part` and checks that it is closed. The number of triangles.
Result<std::size_t> render_stl(const std::string& scad_path, const std::string& part,
                               const std::string& stl_path);

}  // namespace hedgehog::design
