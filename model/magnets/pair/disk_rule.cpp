// SPDX-License-Identifier: MIT
#include "model/magnets/pair/disk_rule.h"

#include <cassert>
#include <cmath>
#include <numbers>

namespace hedgehog::model {
namespace {

struct Legendre {
  double value = 0.0;
  double slope = 0.0;
};

/// The Legendre polynomial of degree n. REQUIRES: n >= 1, |x| < 1.
Legendre legendre(int n, double x) noexcept {
  double before = 1.0;
  double now = x;
  for (int k = 2; k <= n; ++k) {
    const double next = ((2 * k - 1) * x * now - (k - 1) * before) / k;
    before = now;
    now = next;
  }
  return {now, n * (x * now - before) / (x * x - 1.0)};
}

DiskRule make_rule(int n) noexcept {
  DiskRule rule;
  rule.order = n;
  for (int i = 0; i < n; ++i) {
    double x = std::cos(std::numbers::pi * (i + 0.75) / (n + 0.5));
    for (int newton = 0; newton < 8; ++newton) {
      const Legendre p = legendre(n, x);
      x -= p.value / p.slope;
    }
    const double slope = legendre(n, x).slope;
    const auto at = static_cast<std::size_t>(i);
    rule.radius[at] = std::sqrt(0.5 * (1.0 + x));
    rule.weight[at] = 1.0 / ((1.0 - x * x) * slope * slope);
  }
  for (int j = 0; j < 2 * n; ++j) {
    const double phi = std::numbers::pi * (j + 0.5) / (2 * n);
    rule.cosine[static_cast<std::size_t>(j)] = std::cos(phi);
    rule.sine[static_cast<std::size_t>(j)] = std::sin(phi);
  }
  return rule;
}

using Rules = std::array<DiskRule, DiskRule::kMaxOrder>;

Rules make_rules() noexcept {
  Rules rules;
  for (int n = 1; n <= DiskRule::kMaxOrder; ++n)
    rules[static_cast<std::size_t>(n - 1)] = make_rule(n);
  return rules;
}

}  // namespace

const DiskRule& disk_rule(int order) noexcept {
  assert(order >= 1 && order <= DiskRule::kMaxOrder);
  static const Rules rules = make_rules();
  return rules[static_cast<std::size_t>(order - 1)];
}

}  // namespace hedgehog::model
