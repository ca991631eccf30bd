// SPDX-License-Identifier: MIT
// The folders of the sources and of this test's build. Functions, not macros defined for every
// compilation: test objects of all checkouts are then equal, and a compiler cache can share them.
#pragma once

#include <string>

namespace hedgehog {

/// Without a slash at the end.
std::string source_folder();
std::string build_folder();

}  // namespace hedgehog
