// SPDX-License-Identifier: MIT
// Where the sources are, and the build that made this test. Functions, not definitions of every
// compilation: objects of another checkout's tests are the same, so that a compiler cache has them.
#pragma once

#include <string>

namespace hedgehog {

/// Without a slash at the end.
std::string source_folder();
std::string build_folder();

}  // namespace hedgehog
