// SPDX-License-Identifier: MIT
#include "model/magnets/pair/cylinder_magnet.h"

#include <numbers>

namespace hedgehog::model {
namespace {

constexpr double kMaxMagnetMm = 1000.0;
constexpr double kLargestRemanenceT = 2.0;

double volume_mm3(const CylinderMagnet& magnet) noexcept {
  return std::numbers::pi * magnet.radius_mm() * magnet.radius_mm() * magnet.height_mm;
}

}  // namespace

std::optional<std::string> problem_with(const CylinderMagnet& magnet, const std::string& what) {
  const auto size_ok = [](double mm) { return mm > 0.0 && mm <= kMaxMagnetMm; };
  if (!size_ok(magnet.diameter_mm)) return what + ": the diameter must be above 0 and at most 1 m";
  if (!size_ok(magnet.height_mm)) return what + ": the height must be above 0 and at most 1 m";
  if (!(magnet.remanence_t > 0.0 && magnet.remanence_t <= kLargestRemanenceT))
    return what + ": the remanence must be above 0 and at most 2 T";
  return std::nullopt;
}

double moment_a_m2(const CylinderMagnet& magnet) noexcept {
  return magnet.remanence_t / kVacuumPermeability * volume_mm3(magnet) * 1e-9;
}

double mass_g(const CylinderMagnet& magnet) noexcept {
  return kMagnetDensityGMm3 * volume_mm3(magnet);
}

}  // namespace hedgehog::model
