// SPDX-License-Identifier: MIT
// Nodes for integrals over a disk: Gauss-Legendre in the square of the radius, midpoints around.
// Tables made by the first call (some 50 us, no allocation); any thread.
#pragma once

#include <array>
#include <cstddef>

namespace hedgehog::model {

/// With n radii and 4n points round the whole disk every polynomial of degree below 4n is exact.
struct DiskRule {
  static constexpr int kMaxOrder = 40;

  int order = 0;
  /// As a part of the disk's radius; the weights add up to 1.
  std::array<double, kMaxOrder> radius{};
  std::array<double, kMaxOrder> weight{};
  /// Of the 2n midpoints from 0 to pi, which mirror the other half.
  std::array<double, 2 * kMaxOrder> cosine{};
  std::array<double, 2 * kMaxOrder> sine{};
};

/// REQUIRES: 1 <= order <= DiskRule::kMaxOrder.
const DiskRule& disk_rule(int order) noexcept;

}  // namespace hedgehog::model
