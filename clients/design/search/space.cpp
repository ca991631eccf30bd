// SPDX-License-Identifier: MIT
#include "clients/design/search/space.h"

#include <algorithm>
#include <tuple>

namespace hedgehog::design {
namespace {

// Nanometres and micrograms are rounding errors, not differences.
constexpr double kSame = 1e-9;

auto rank(const Found& found) {
  return std::tuple(found.outer_diameter_mm, -static_cast<double>(found.pins), -found.extension_mm,
                    found.mass_g, found.design.shield.diameter_mm, found.design.shield.height_mm,
                    found.design.array);
}

/// Indices into `sorted` of those that no other dominates, except those left out.
std::vector<std::size_t> front_of(const std::vector<Found>& sorted,
                                  const std::function<bool(std::size_t)>& left_out) {
  std::vector<std::size_t> front;
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    if (left_out(i)) continue;
    const Found& one = sorted[i];
    if (std::any_of(front.begin(), front.end(),
                    [&](std::size_t other) { return dominates(sorted[other], one); }))
      continue;
    std::erase_if(front, [&](std::size_t other) { return dominates(one, sorted[other]); });
    front.push_back(i);
  }
  return front;
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

CheckedFront checked_front(std::vector<Found> found, const Check& check) {
  // In this order no design is dominated by a later one, except for ties in the first number.
  std::sort(found.begin(), found.end(),
            [](const Found& a, const Found& b) { return rank(a) < rank(b); });
  enum class Answer : char { kUnchecked, kAccepted, kRefused };
  std::vector<Answer> answers(found.size(), Answer::kUnchecked);
  CheckedFront checked;
  while (true) {
    const std::vector<std::size_t> front =
        front_of(found, [&](std::size_t i) { return answers[i] == Answer::kRefused; });
    std::vector<std::size_t> asked;
    std::vector<Found> some;
    for (const std::size_t i : front) {
      if (answers[i] != Answer::kUnchecked) continue;
      asked.push_back(i);
      some.push_back(found[i]);
    }
    if (asked.empty()) {
      for (const std::size_t i : front) checked.front.push_back(std::move(found[i]));
      std::sort(checked.front.begin(), checked.front.end(),
                [](const Found& a, const Found& b) { return rank(a) < rank(b); });
      return checked;
    }
    const std::vector<std::optional<Found>> built = check(some);
    for (std::size_t i = 0; i < asked.size(); ++i) {
      answers[asked[i]] = built[i] ? Answer::kAccepted : Answer::kRefused;
      if (built[i])
        found[asked[i]] = *built[i];
      else
        ++checked.refused;
    }
  }
}

}  // namespace hedgehog::design
