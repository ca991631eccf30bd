// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace hedgehog::protocol {

/// `path` of a JSON value, extended by the member `name`.
inline std::string child_path(std::string path, std::string_view name) {
  path += '.';
  path += name;
  return path;
}

}  // namespace hedgehog::protocol
