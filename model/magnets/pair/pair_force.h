// SPDX-License-Identifier: MIT
// PairForce(alpha, o) of the thesis (section 2.2, Fig. 2.5): the force along its own axis on one of
// two magnets on a sphere, by charged cylinders instead of the thesis' finite elements
// (model/magnets/forces.md). Pure; any thread.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string_view>

#include "model/magnets/pair/cylinder_magnet.h"

namespace hedgehog::model {

enum class ForceModel : std::uint8_t {
  kExact,   ///< charged cylinders at every angle
  kHybrid,  ///< the thesis' (2.1): exact below 30 degrees, dipoles beyond
  kDipole,  ///< two point dipoles at the centres of the magnets
};

/// "exact", "hybrid", "dipole".
std::string_view name_of(ForceModel model) noexcept;
std::optional<ForceModel> force_model_named(std::string_view name) noexcept;

inline constexpr double kHybridAngleDeg = 30.0;  // from here the hybrid uses dipoles
constexpr bool takes_dipoles(ForceModel model, double angle_deg) noexcept {
  return model == ForceModel::kDipole ||
         (model == ForceModel::kHybrid && angle_deg >= kHybridAngleDeg);
}

/// Accuracies are clamped to this range.
inline constexpr double kFinestAccuracy = 1e-10;
inline constexpr double kCoarsestAccuracy = 0.1;
constexpr double clamped(double accuracy) noexcept {
  return std::clamp(accuracy, kFinestAccuracy, kCoarsestAccuracy);
}

struct ForceSettings {
  ForceModel model = ForceModel::kExact;
  /// Relative error of each pair's result (near a zero: relative to 1e-4 of the force on one face).
  /// Not reached where magnets almost touch: see `error_n`.
  double accuracy = 1e-6;
};

/// Two magnets with inner faces on one sphere, axes through its centre, both with north outwards.
/// For opposite polarity the force changes its sign.
struct MagnetPair {
  CylinderMagnet subject = kThesisPinMagnet;  // the force acts on it
  CylinderMagnet other = kThesisShieldMagnet;
  double sphere_radius_mm = 35.0;
};

/// The offset of a magnet is the distance of its inner face from the sphere, outside positive.
struct PairPlace {
  double angle_deg = 0.0;  // between the two axes, 0..180
  double offset_mm = 0.0;
  double other_offset_mm = 0.0;
};

struct PairForce {
  double force_n = 0.0;  // on the subject along its own axis, outwards positive
  double error_n = 0.0;  // bound on the quadrature error, without the model's: 0 for dipoles
};

/// REQUIRES: valid sizes, gap_mm(pair, place) > 0; overlapping magnets have no meaningful force.
PairForce pair_force(const MagnetPair& pair, const PairPlace& place,
                     const ForceSettings& settings = {}) noexcept;

/// The same with the other magnet on the sphere.
inline PairForce pair_force(const MagnetPair& pair, double angle_deg, double offset_mm,
                            ForceModel model, double accuracy) noexcept {
  return pair_force(pair, {angle_deg, offset_mm, 0.0}, {model, accuracy});
}

/// Smallest distance between the two bodies; negative: depth of the overlap.
double gap_mm(const MagnetPair& pair, const PairPlace& place) noexcept;

}  // namespace hedgehog::model
