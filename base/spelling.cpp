// SPDX-License-Identifier: MIT
#include "base/spelling.h"

#include <algorithm>
#include <numeric>
#include <vector>

namespace hedgehog::base {

std::string lower_case(std::string_view text) {
  std::string out(text);
  std::transform(out.begin(), out.end(), out.begin(), [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  });
  return out;
}

std::size_t edits_between(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({row[j] + 1, row[j + 1] + 1, replaced});
    }
  }
  return row.back();
}

std::string_view nearest(std::string_view text, std::span<const std::string_view> names) {
  constexpr std::size_t kLongest = 64;
  constexpr std::string_view kBeforeLastPart = "_.-";
  if (text.size() > kLongest || text.empty()) return {};
  std::string_view best;
  std::size_t lowest = std::max<std::size_t>(2, text.size() / 3) + 1;
  for (const std::string_view candidate : names) {
    const bool lacks_last_part =
        candidate.size() > text.size() && candidate.starts_with(text) &&
        kBeforeLastPart.find(candidate[text.size()]) != std::string_view::npos;
    const std::size_t apart = lacks_last_part ? 0 : edits_between(text, candidate);
    if (apart < lowest) {
      lowest = apart;
      best = candidate;
    }
  }
  return best;
}

}  // namespace hedgehog::base
