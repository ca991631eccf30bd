// SPDX-License-Identifier: MIT
// PairForce(alpha, o) of the thesis (section 2.2, Fig. 2.5): the force along its own axis on one of
// two magnets that stand on a sphere. What the thesis took from finite elements is computed here
// from the charged-cylinder model: the other magnet's field, integrated over both end faces (Gauss
// in the square of the radius, midpoints round half the disk, the rest being its mirror image).
// Pure; any thread.
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
  kDipole,  ///< two point dipoles in the middles of the magnets
};

/// "exact", "hybrid", "dipole".
std::string_view name_of(ForceModel model) noexcept;
std::optional<ForceModel> force_model_named(std::string_view name) noexcept;

/// From this angle on the hybrid takes the dipole model.
inline constexpr double kHybridAngleDeg = 30.0;
/// Whether a model takes dipoles at an angle.
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

/// How a force is to be computed.
struct ForceSettings {
  ForceModel model = ForceModel::kExact;
  /// How far each pair's result may be from the model's exact value, as a part of it (at a zero: of
  /// what a face alone feels, times 1e-4). Not reached where magnets all but touch: see `error_n`.
  double accuracy = 1e-6;
};

/// Two magnets whose inner faces rest on one sphere, axes through its centre, both polarised
/// outwards. For opposite polarity the force changes its sign.
struct MagnetPair {
  /// The magnet that the force is on.
  CylinderMagnet subject = kThesisPinMagnet;
  CylinderMagnet other = kThesisShieldMagnet;
  double sphere_radius_mm = 35.0;
};

/// The offset of a magnet is how far its inner face is outside the sphere; inside is negative.
struct PairPlace {
  /// Between the two axes, 0..180.
  double angle_deg = 0.0;
  double offset_mm = 0.0;
  double other_offset_mm = 0.0;
};

struct PairForce {
  /// On the subject along its own axis, outwards positive, N.
  double force_n = 0.0;
  /// Bound on the quadrature's error, N, by comparison of two orders. Says nothing about the model:
  /// 0 for dipoles.
  double error_n = 0.0;
};

/// REQUIRES: sizes without problem, gap_mm(pair, place) > 0 (inside each other the number means
/// nothing, and the requested accuracy may not be reached: then error_n says so).
PairForce pair_force(const MagnetPair& pair, const PairPlace& place,
                     const ForceSettings& settings = {}) noexcept;

/// The same with the other magnet on the sphere.
inline PairForce pair_force(const MagnetPair& pair, double angle_deg, double offset_mm,
                            ForceModel model, double accuracy) noexcept {
  return pair_force(pair, {angle_deg, offset_mm, 0.0}, {model, accuracy});
}

/// The smallest distance between the two bodies, mm; when they overlap minus how deep.
double gap_mm(const MagnetPair& pair, const PairPlace& place) noexcept;

}  // namespace hedgehog::model
