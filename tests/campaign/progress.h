// SPDX-License-Identifier: MIT
// A progress bar on a terminal, ten lines elsewhere.
#pragma once

#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>

namespace hedgehog::campaign {

inline void show_progress(const char* what, std::uint64_t done, std::uint64_t all) {
  static const bool terminal = isatty(STDERR_FILENO) != 0;
  constexpr int kWidth = 40;
  if (terminal) {
    const int full = static_cast<int>(kWidth * done / all);
    std::fprintf(stderr, "\r%s [%.*s%*s] %llu/%llu", what, full,
                 "########################################", kWidth - full, "",
                 static_cast<unsigned long long>(done), static_cast<unsigned long long>(all));
    if (done == all) std::fputc('\n', stderr);
  } else if (done == all || done % std::max<std::uint64_t>(1, all / 10) == 0) {
    std::fprintf(stderr, "%s %llu/%llu\n", what, static_cast<unsigned long long>(done),
                 static_cast<unsigned long long>(all));
  }
}

}  // namespace hedgehog::campaign
