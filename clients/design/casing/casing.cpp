// SPDX-License-Identifier: MIT
#include "clients/design/casing/casing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "clients/design/casing/stl.h"
#include "clients/design/output/table.h"
#include "clients/design/output/tool.h"
#include "model/units.h"

namespace hedgehog::design {
namespace {

using model::Vec3;

constexpr double kTabHeightMm = 3.0;
constexpr double kWidestFanMm = 40.0;
constexpr double kWallMm = 1.5;

/// Distance of a point from the line out of the centre along `direction`.
double distance_to_axis(const Vec3& point, const Vec3& direction) {
  return model::norm(point - model::dot(point, direction) * direction);
}

}  // namespace

double outer_radius_mm(double sphere_mm, const Size& pin, const Size& shield) noexcept {
  return sphere_mm + std::max(pin.height_mm + kPinTravelMm, shield.height_mm) + kRoofMm;
}

double cavity_reach_mm(const Casing& casing, const Size& magnet) noexcept {
  const double radius = magnet.diameter_mm / 2.0;
  return std::max(radius + casing.clearance_mm,
                  radius / std::cos(std::numbers::pi / casing.facets));
}

Casing casing_of(const Design& design, const model::Arrangement& array) {
  Casing casing;
  casing.sphere_mm = design.sphere_mm;
  casing.pin = design.magnet;
  casing.shield = design.shield;
  for (const auto& site : array.pins) casing.pins.push_back(site.direction);
  for (const auto& site : array.shields) casing.shields.push_back(site.direction);
  return casing;
}

double widest_clearance_mm(Casing casing, const model::Arrangement& array) {
  for (const double clearance_mm : {kUsualClearanceMm, 0.1, 0.05}) {
    casing.clearance_mm = clearance_mm;
    if (thinnest_wall(casing, array).mm >= kMinWallMm) break;
  }
  return casing.clearance_mm;
}

double volume_mm3(const Casing& casing) noexcept {
  const double inner = casing.sphere_mm;
  const double outer = outer_radius_mm(casing.sphere_mm, casing.pin, casing.shield);
  const double corners = casing.facets;
  const auto polygon_mm2 = [&](double reach_mm) {
    return 0.5 * corners * reach_mm * reach_mm * std::sin(2.0 * std::numbers::pi / corners);
  };
  // The part above the sphere, and the part between the sphere and the plane at its top.
  const auto cavity_mm3 = [&](const Size& magnet, double depth_mm) {
    const double reach_mm = cavity_reach_mm(casing, magnet);
    return polygon_mm2(reach_mm) * (depth_mm + reach_mm * reach_mm / (4.0 * inner));
  };
  const double hole_mm = kPinHoleShare * casing.pin.diameter_mm / 2.0;
  const double end_mm = casing.pin.height_mm + kPinTravelMm;
  const double pin_mm3 = cavity_mm3(casing.pin, end_mm) +
                         std::numbers::pi * hole_mm * hole_mm * (outer - inner - end_mm);
  const double fan_mm3 = std::numbers::pi / 4.0 * casing.fan_mm * casing.fan_mm * (outer - inner);
  const double shell_mm3 =
      4.0 / 3.0 * std::numbers::pi * (outer * outer * outer - inner * inner * inner);
  return shell_mm3 - static_cast<double>(casing.pins.size()) * pin_mm3 -
         static_cast<double>(casing.shields.size()) *
             cavity_mm3(casing.shield, casing.shield.height_mm) -
         fan_mm3;
}

Wall thinnest_wall(const Casing& casing, const model::Arrangement& array) {
  struct Cavity {
    model::CylinderMagnet space;
    double mouth_mm;
  };
  const auto cavity = [&](model::MagnetKind kind) {
    const Size& magnet = kind == model::MagnetKind::kPin ? casing.pin : casing.shield;
    const double reach = cavity_reach_mm(casing, magnet);
    // At its rim the inner surface of the casing is lower than in the middle.
    const double mouth =
        std::sqrt(std::max(0.0, casing.sphere_mm * casing.sphere_mm - reach * reach));
    return Cavity{{2.0 * reach, magnet.height_mm}, mouth - casing.sphere_mm};
  };
  const model::ArraySizes sizes{{casing.pin.diameter_mm, casing.pin.height_mm},
                                {casing.shield.diameter_mm, casing.shield.height_mm},
                                casing.sphere_mm};
  Wall thinnest{1e9, {}};
  for (const model::MagnetGap& gap : model::smallest_gaps(array, sizes)) {
    const Cavity a = cavity(gap.kind_a);
    const Cavity b = cavity(gap.kind_b);
    const double mm = model::gap_mm({a.space, b.space, casing.sphere_mm},
                                    {gap.angle_deg, a.mouth_mm, b.mouth_mm});
    if (mm >= thinnest.mm) continue;
    thinnest = {mm, std::string(model::name_of(gap.kind_a)) + " " + std::to_string(gap.id_a) +
                        " and " + std::string(model::name_of(gap.kind_b)) + " " +
                        std::to_string(gap.id_b)};
  }
  return thinnest;
}

std::vector<double> notch_places(const Casing& casing) {
  const double r = outer_radius_mm(casing.sphere_mm, casing.pin, casing.shield) - kRoofMm / 2.0;
  const auto clearance_at = [&](double degrees) {
    const Vec3 tab{r * std::cos(degrees * model::kRadiansPerDegree),
                   r * std::sin(degrees * model::kRadiansPerDegree), kTabHeightMm / 2.0};
    double clearance = 1e9;
    for (const Vec3& pin : casing.pins)
      if (model::dot(pin, tab) > 0.0) clearance = std::min(clearance, distance_to_axis(tab, pin));
    return clearance;
  };
  std::vector<double> places;
  for (const int aimed : {40, 150, 265}) {
    int best = aimed;
    for (int degrees = aimed - 12; degrees <= aimed + 12; ++degrees)
      if (clearance_at(degrees) > clearance_at(best) + 1e-9) best = degrees;
    places.push_back(best);
  }
  return places;
}

double widest_fan_mm(const Casing& casing) {
  const double inner = casing.sphere_mm;
  double radius = kWidestFanMm / 2.0;
  const auto keep_away = [&](const std::vector<Vec3>& directions, const Size& size) {
    for (const Vec3& direction : directions) {
      if (direction.z >= 0.0) continue;
      const double across = std::hypot(direction.x, direction.y);
      // The nearest point of the cavity is at its inner end.
      const double rim = inner * across - cavity_reach_mm(casing, size) * -direction.z;
      radius = std::min(radius, rim - kWallMm);
    }
  };
  keep_away(casing.pins, casing.pin);
  keep_away(casing.shields, casing.shield);
  radius -= kCableMm;
  return radius < 5.0 ? 0.0 : 2.0 * std::floor(2.0 * radius) / 2.0;
}

Result<std::size_t> render_stl(const std::string& scad_path, const std::string& part,
                               const std::string& stl_path) {
  const auto writable = check_writable(stl_path);
  if (!writable) return writable.error();
  const auto rendered = run_tool(
      {"openscad", "-q", "-o", stl_path, "-D", "part=\"" + part + "\"", scad_path}, "openscad");
  if (!rendered) return rendered.error();
  const auto text = read_file(stl_path);
  if (!text) return text.error();
  const auto surface = check_stl(*text);
  if (!surface) return Problem{kToolFailed, stl_path + ": " + surface.error().message};
  if (surface->open_edges > 0) {
    return Problem{kToolFailed, stl_path +
                                    " is not closed: " + std::to_string(surface->open_edges) +
                                    " edges have no counterpart"};
  }
  return surface->triangles;
}

}  // namespace hedgehog::design
