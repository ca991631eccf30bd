// SPDX-License-Identifier: MIT
// Force vector between two cylinders anywhere in space. Slower than pair_force, which assumes
// magnets on one sphere and uses their mirror plane. Pure; any thread.
#pragma once

#include "model/magnets/pair/cylinder_magnet.h"
#include "model/vec3.h"

namespace hedgehog::model {

struct PlacedMagnet {
  CylinderMagnet magnet;
  /// Its centre, mm.
  Vec3 centre_mm;
  /// From south to north pole, length 1.
  Vec3 axis{0, 0, 1};
};

/// Flux density at a point outside the magnet, tesla.
Vec3 field_at(const PlacedMagnet& magnet, const Vec3& point_mm) noexcept;

/// Force of `other` on `subject`, N, charged-cylinder model. `order`: Gauss nodes along a radius,
/// 1..DiskRule::kMaxOrder; four times as many around. REQUIRES: the magnets do not overlap.
Vec3 force_between(const PlacedMagnet& subject, const PlacedMagnet& other, int order) noexcept;

}  // namespace hedgehog::model
