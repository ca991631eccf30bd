// SPDX-License-Identifier: MIT
// Random corruption of a line or file.
#pragma once

#include <string>

#include "tests/soak/random.h"

namespace hedgehog::soak {

/// `text` with some bytes changed, lost, doubled or inserted; these include NUL and invalid UTF-8.
inline std::string damaged(Random& random, std::string text) {
  const std::size_t times = 1 + random.below(3);
  for (std::size_t i = 0; i < times; ++i) {
    const std::size_t at = random.below(text.size() + 1);
    switch (random.below(6)) {
      case 0:
        if (at < text.size()) text[at] = static_cast<char>(text[at] ^ (1 << random.below(8)));
        break;
      case 1:
        text.erase(at, 1 + random.below(8));
        break;
      case 2:
        text.insert(at, random.bytes(1 + random.below(4)));
        break;
      case 3:
        text.insert(at, 1, '\0');
        break;
      case 4:
        text.insert(at, text.substr(at / 2, random.below(40)));
        break;
      default:
        text.resize(at);
    }
  }
  return text;
}

/// `text` without line feeds, which would split it into two lines on some transports.
inline std::string one_line(std::string text) {
  for (char& c : text)
    if (c == '\n') c = ' ';
  return text;
}

}  // namespace hedgehog::soak
