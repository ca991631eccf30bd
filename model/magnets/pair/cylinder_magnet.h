// SPDX-License-Identifier: MIT
// An axially magnetised cylinder and its exact field: uniformly magnetised with the permeability of
// vacuum (a real N45 has 1.05, which is neglected), so that it acts as two charged end faces.
// Lengths here and in all of model/magnets are millimetres, as in drawings. Pure; any thread.
#pragma once

#include <numbers>
#include <optional>
#include <string>

namespace hedgehog::model {

/// Permeability of vacuum mu0, H/m; the CODATA value since 2019 differs by 2e-10 of it.
inline constexpr double kVacuumPermeability = 4e-7 * std::numbers::pi;
/// Residual flux density of N45 (thesis section 2.3).
inline constexpr double kN45RemanenceT = 1.37;
/// Sintered neodymium magnets, g/mm^3.
inline constexpr double kMagnetDensityGMm3 = 7.5e-3;

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

/// Dipole moment, A m^2: remanence * volume / mu0.
double moment_a_m2(const CylinderMagnet& magnet) noexcept;
double mass_g(const CylinderMagnet& magnet) noexcept;

/// Flux density in the plane through the axis, tesla.
struct AxialField {
  double radial_t = 0.0;
  double axial_t = 0.0;
};

/// The field at `rho_mm` >= 0 from the axis and `z_mm` above the middle of the magnet, which points
/// up: Derby and Olbert, "Cylindrical magnets and ideal solenoids" (2010), with both complete
/// elliptic integrals of each end from one arithmetic-geometric mean. Accuracy about 1e-13 of the
/// largest term; diverges on the rims.
AxialField field_of(const CylinderMagnet& magnet, double rho_mm, double z_mm) noexcept;

}  // namespace hedgehog::model
