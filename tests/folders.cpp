// SPDX-License-Identifier: MIT
#include "tests/folders.h"

namespace hedgehog {

std::string source_folder() { return HEDGEHOG_SOURCE_DIR; }
std::string build_folder() { return HEDGEHOG_BUILD_DIR; }

}  // namespace hedgehog
