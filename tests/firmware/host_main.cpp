// SPDX-License-Identifier: MIT
// The vectors on the host.
#include <cstdio>
#include <cstdlib>

#include "tests/firmware/vectors.h"

int main() {
  const bool good = hedgehog::firmware::run_vectors([](const char* line) { std::puts(line); });
  return good ? EXIT_SUCCESS : EXIT_FAILURE;
}
