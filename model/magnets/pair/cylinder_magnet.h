// SPDX-License-Identifier: MIT
// An axially magnetised cylinder and its exact field, that of two charged end faces (permeability
// of vacuum; a real N45 has 1.05). Lengths in model/magnets are millimetres. Pure; any thread.
#pragma once

#include <numbers>
#include <optional>
#include <string>

namespace hedgehog::model {

inline constexpr double kVacuumPermeability = 4e-7 * std::numbers::pi;  // mu0, H/m
inline constexpr double kN45RemanenceT = 1.37;                          // thesis section 2.3
inline constexpr double kMagnetDensityGMm3 = 7.5e-3;                    // sintered neodymium

/// Polarity: see `MagnetPair`.
struct CylinderMagnet {
  double diameter_mm = 0.0;
  double height_mm = 0.0;
  double remanence_t = kN45RemanenceT;

  constexpr double radius_mm() const noexcept { return 0.5 * diameter_mm; }
  friend constexpr bool operator==(const CylinderMagnet&, const CylinderMagnet&) noexcept = default;
};

/// Thesis Table 2.2.
inline constexpr CylinderMagnet kThesisPinMagnet{8.0, 10.0};
inline constexpr CylinderMagnet kThesisShieldMagnet{4.0, 10.0};

/// Error in the sizes, one sentence; nullopt if diameter and height are in (0, 1000] mm and the
/// remanence in (0, 2] T. `what`: name of the magnet in the sentence, e.g. "the shield".
std::optional<std::string> problem_with(const CylinderMagnet& magnet, const std::string& what);

/// Dipole moment: remanence * volume / mu0.
double moment_a_m2(const CylinderMagnet& magnet) noexcept;
double mass_g(const CylinderMagnet& magnet) noexcept;

/// Flux density in the plane through the axis.
struct AxialField {
  double radial_t = 0.0;
  double axial_t = 0.0;
};

/// The field at `rho_mm` >= 0 from the axis and `z_mm` above the middle of the magnet, which points
/// up: Derby and Olbert, "Cylindrical magnets and ideal solenoids" (2010). Accuracy about 1e-13 of
/// the largest term; diverges on the rims.
AxialField field_of(const CylinderMagnet& magnet, double rho_mm, double z_mm) noexcept;

}  // namespace hedgehog::model
