// SPDX-License-Identifier: MIT
// The files of config/patterns at build time, which generates the .cpp.
#pragma once

#include <span>
#include <string_view>

namespace hedgehog::server {

struct ShippedFile {
  std::string_view name;  // without ".json"
  std::string_view json;
};
std::span<const ShippedFile> shipped_pattern_files() noexcept;

}  // namespace hedgehog::server
