// SPDX-License-Identifier: MIT
#include "clients/design/search/space.h"

#include <algorithm>
#include <tuple>

namespace hedgehog::design {
namespace {

// Nanometres and micrograms are rounding, not merit.
constexpr double kSame = 1e-9;

auto rank(const Found& found) {
  return std::tuple(found.outer_diameter_mm, -static_cast<double>(found.pins), -found.extension_mm,
                    found.mass_g, found.design.shield.diameter_mm, found.design.shield.height_mm,
                    found.design.array);
}

}  // namespace

bool dominates(const Found& a, const Found& b) noexcept {
  const bool no_worse = a.pins >= b.pins && a.extension_mm >= b.extension_mm - kSame &&
                        a.mass_g <= b.mass_g + kSame &&
                        a.outer_diameter_mm <= b.outer_diameter_mm + kSame;
  const bool better = a.pins > b.pins || a.extension_mm > b.extension_mm + kSame ||
                      a.mass_g < b.mass_g - kSame ||
                      a.outer_diameter_mm < b.outer_diameter_mm - kSame;
  return no_worse && better;
}

std::vector<Found> pareto_front(std::vector<Found> found) {
  // In this order nothing is dominated by what comes after it, but for ties in the first number.
  std::sort(found.begin(), found.end(),
            [](const Found& a, const Found& b) { return rank(a) < rank(b); });
  std::vector<Found> front;
  for (const Found& one : found) {
    if (std::any_of(front.begin(), front.end(),
                    [&](const Found& other) { return dominates(other, one); }))
      continue;
    std::erase_if(front, [&](const Found& other) { return dominates(one, other); });
    front.push_back(one);
  }
  return front;
}

}  // namespace hedgehog::design
