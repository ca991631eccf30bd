// SPDX-License-Identifier: MIT
// The flux of one magnet through an end face of another: a force is the difference of two of them.
// A detail of pair_force and force_curve. No allocation; any thread.
#pragma once

#include "model/magnets/pair/pair_force.h"

namespace hedgehog::model {

/// Contribution of one face, without sign.
struct FaceForce {
  double force_n = 0.0;
  double error_n = 0.0;
  int order = 0;  // of the disk rule; 0: not computed yet
};

/// Flux through any end face on the subject's axis, at one angle.
class FaceFlux {
 public:
  FaceFlux(const MagnetPair& pair, double angle_deg, double other_offset_mm) noexcept;

  /// At `distance_mm` from the sphere's centre, with the order expected to suffice.
  FaceForce first(double distance_mm, double accuracy) const noexcept;
  /// The same face with the order expected to reduce the error to `tolerance_n`; at least one more
  /// than `known`. REQUIRES: 0 < known.order < DiskRule::kMaxOrder.
  FaceForce refined(double distance_mm, const FaceForce& known, double tolerance_n) const noexcept;

 private:
  struct Integral {
    double force_n = 0.0;
    double gross_n = 0.0;  // sum of absolute values over the face
  };
  Integral integral(double distance_mm, int order) const noexcept;
  double axial_field(double across_mm, double beside_mm, double distance_mm) const noexcept;
  FaceForce compared(double distance_mm, int order, double coarse_n,
                     int coarse_order) const noexcept;
  double rim_ratio(double distance_mm) const noexcept;

  CylinderMagnet other_;
  double radius_mm_;
  double sine_;
  double cosine_;
  double other_middle_mm_;
  double newton_per_tesla_;
};

/// Refines the faces in turn until top - bottom reaches the accuracy (`ForceSettings`).
PairForce settle(const FaceFlux& flux, double bottom_mm, FaceForce& bottom, double top_mm,
                 FaceForce& top, double accuracy) noexcept;

}  // namespace hedgehog::model
