// SPDX-License-Identifier: MIT
// Exact field of a cylinder: only arithmetic on local pairs of doubles, see model/CMakeLists.txt.
#include <Eigen/Core>
#include <cmath>

#include "model/magnets/pair/cylinder_magnet.h"

namespace hedgehog::model {
namespace {

/// One lane for each end of the magnet.
using Ends = Eigen::Array2d;

/// Bulirsch's complete integrals cel(k,1,1,-1) and cel(k,gamma^2,1,gamma), without the factor pi/2.
struct EndIntegrals {
  Ends radial;
  Ends axial;
};

/// Both use the same iteration of (em, kk); p of the first stays equal to em.
EndIntegrals end_integrals(Ends k, double gamma) noexcept {
  // The remaining error is of the order of its square.
  constexpr double kClose = 1e-8;
  const double sign = gamma < 0.0 ? -1.0 : 1.0;
  const double p = std::abs(gamma);
  Ends kk = k;
  Ends em = 1.0 + k;
  Ends cc_radial = Ends::Zero();
  Ends ss_radial = 2.0 * (k - 1.0);
  Ends cc = Ends::Constant(1.0 + sign / p);
  Ends g = k / p;
  Ends ss = 2.0 * (sign + g);
  Ends pp = p + g;
  Ends mean = Ends::Ones();
  while (((mean - k).abs() > mean * kClose).any()) {
    k = 2.0 * kk.sqrt();
    kk = k * em;
    const Ends f_radial = cc_radial;
    cc_radial += ss_radial / em;
    ss_radial = 2.0 * (ss_radial + f_radial * k);
    const Ends f = cc;
    const Ends part = pp.inverse();
    cc += ss * part;
    g = kk * part;
    ss = 2.0 * (ss + f * g);
    pp += g;
    mean = em;
    em += k;
  }
  return {(ss_radial + cc_radial * em) / (2.0 * em * em), (ss + cc * em) / (em * (em + pp))};
}

}  // namespace

AxialField field_of(const CylinderMagnet& magnet, double rho_mm, double z_mm) noexcept {
  const double a = magnet.radius_mm();
  const double half = 0.5 * magnet.height_mm;
  const double wide = a + rho_mm;
  const double narrow = a - rho_mm;
  // At the lateral surface the jumps of both ends cancel; close to it they cancel in the limit.
  const double ratio = narrow / wide;
  const double gamma = std::abs(ratio) < 1e-12 ? 1e-12 : ratio;
  const Ends z(z_mm + half, z_mm - half);
  const Ends z2 = z * z;
  const Ends far2 = z2 + wide * wide;
  const Ends k = ((z2 + narrow * narrow) / far2).sqrt().max(1e-150);
  const Ends scale = far2.sqrt().inverse();
  const EndIntegrals c = end_integrals(k, gamma);
  const Ends radial = scale * c.radial;
  const Ends axial = z * scale * c.axial;
  // Factor 0.5: pi/2 of the integrals over pi of the field.
  return {0.5 * magnet.remanence_t * a * (radial[0] - radial[1]),
          0.5 * magnet.remanence_t * a / wide * (axial[0] - axial[1])};
}

}  // namespace hedgehog::model
