// SPDX-License-Identifier: MIT
// soak [--seconds N | --rounds N] [--seed N] [--actions N] [--starts N]: rounds with the seeds N, N
// + 1, ... on the programs in the environment variable HEDGEHOG_PROGRAMS. Exit: 1 after a failure.
#include <sysexits.h>

#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>

#include "tests/e2e/programs.h"
#include "tests/soak/soak.h"

int main(int argc, char** argv) {
  namespace soak = hedgehog::soak;
  soak::SoakOptions options;
  options.duration = std::chrono::seconds(600);
  for (int i = 1; i < argc; ++i) {
    const std::string_view word = argv[i];
    if (i + 1 == argc) {
      std::fprintf(stderr, "soak: %s has no value\n", argv[i]);
      return EX_USAGE;
    }
    const auto value = std::strtoull(argv[++i], nullptr, 10);
    if (word == "--seconds") {
      options.duration = std::chrono::seconds(value);
    } else if (word == "--rounds") {
      options.rounds = value;
      options.duration = {};
    } else if (word == "--seed") {
      options.seed = value;
    } else if (word == "--actions") {
      options.size.actions = static_cast<int>(value);
    } else if (word == "--starts") {
      options.size.starts = static_cast<int>(value);
    } else {
      std::fprintf(stderr, "soak: no option %s\n", argv[i - 1]);
      return EX_USAGE;
    }
  }
  std::setvbuf(stdout, nullptr, _IOLBF, BUFSIZ);
  std::printf("%s, from seed %llu on%s\n", hedgehog::e2e::hedgehogd().c_str(),
              static_cast<unsigned long long>(options.seed),
              soak::may_mount() ? "" : "; no full disks: this user may not mount one");
  soak::Summary summary;
  const std::string failure =
      soak::run_soak(options, summary, [&] { std::printf("%s\n", summary.line().c_str()); });
  std::printf("%s", summary.text().c_str());
  if (failure.empty()) return EXIT_SUCCESS;
  std::fprintf(stderr, "%s\nAgain: soak --rounds 1 --seed N with the seed above\n",
               failure.c_str());
  return EXIT_FAILURE;
}
