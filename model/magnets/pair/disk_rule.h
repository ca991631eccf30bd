// SPDX-License-Identifier: MIT
// Nodes for integrals over a disk: Gauss-Legendre in the square of the radius, midpoint rule in the
// angle. Tables are computed in the first call (about 50 us, no allocation); any thread.
#pragma once

#include <array>
#include <cstddef>

namespace hedgehog::model {

/// With n radii and 4n angles, polynomials of degree below 4n are integrated exactly.
struct DiskRule {
  static constexpr int kMaxOrder = 40;

  int order = 0;
  std::array<double, kMaxOrder> radius{};  // as a fraction of the disk's
  std::array<double, kMaxOrder> weight{};  // the sum is 1
  /// Of the 2n midpoints from 0 to pi; the other half is symmetric.
  std::array<double, 2 * kMaxOrder> cosine{};
  std::array<double, 2 * kMaxOrder> sine{};
};

/// REQUIRES: 1 <= order <= DiskRule::kMaxOrder.
const DiskRule& disk_rule(int order) noexcept;

}  // namespace hedgehog::model
