// SPDX-License-Identifier: MIT
#include "model/thermal/thermal_decay.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>

namespace hedgehog::model {

NodeTimeConstants node_time_constants(const ThermalModel& model) noexcept {
  std::array<double, kCoils> winding_s{};
  double from_core_w_k =
      1.0 / std::min(model.core_to_ambient_fan_k_w, model.core_to_ambient_still_k_w);
  for (std::size_t i = 0; i < kCoils; ++i) {
    winding_s[i] = model.winding_j_k[i] * model.winding_to_core_k_w[i];
    from_core_w_k += 1.0 / model.winding_to_core_k_w[i];
  }
  return {*std::min_element(winding_s.begin(), winding_s.end()), model.core_j_k / from_core_w_k};
}

// C dx/dt = -G x, x relative to ambient. In y = sqrt(C) x the matrix is symmetric, so its
// eigenvalues are real and its modes decay independently.
ThermalState decayed(const ThermalModel& model, const ThermalState& nodes, double ambient_c,
                     double seconds) noexcept {
  constexpr int kNodes = kCoils + 1;
  constexpr int kCore = kCoils;
  using Nodes = Eigen::Matrix<double, kNodes, 1>;
  const double t = std::max(0.0, seconds);
  if (t == 0.0) return nodes;
  using Square = Eigen::Matrix<double, kNodes, kNodes>;
  Square conductance_w_k = Square::Zero();
  Nodes root_j_k;
  Nodes above_k;
  conductance_w_k(kCore, kCore) = 1.0 / model.core_to_ambient_still_k_w;
  root_j_k[kCore] = std::sqrt(model.core_j_k);
  above_k[kCore] = nodes.core_c - ambient_c;
  for (int coil = 0; coil < kCoils; ++coil) {
    const auto i = static_cast<std::size_t>(coil);
    const double to_core_w_k = 1.0 / model.winding_to_core_k_w[i];
    conductance_w_k(coil, coil) = to_core_w_k;
    conductance_w_k(kCore, kCore) += to_core_w_k;
    conductance_w_k(coil, kCore) = conductance_w_k(kCore, coil) = -to_core_w_k;
    root_j_k[coil] = std::sqrt(model.winding_j_k[i]);
    above_k[coil] = nodes.winding_c[i] - ambient_c;
  }
  const Nodes per_root = root_j_k.cwiseInverse();
  const Eigen::SelfAdjointEigenSolver<Square> modes(per_root.asDiagonal() * conductance_w_k *
                                                    per_root.asDiagonal());
  const Nodes left = (-t * modes.eigenvalues().cwiseMax(0.0)).array().exp();
  const Nodes amplitude = modes.eigenvectors().transpose() * root_j_k.cwiseProduct(above_k);
  const Nodes later_k = per_root.cwiseProduct(modes.eigenvectors() * left.cwiseProduct(amplitude));

  ThermalState later;
  for (int coil = 0; coil < kCoils; ++coil)
    later.winding_c[static_cast<std::size_t>(coil)] = ambient_c + later_k[coil];
  later.core_c = ambient_c + later_k[kCore];
  return later;
}

}  // namespace hedgehog::model
