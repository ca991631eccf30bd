// SPDX-License-Identifier: MIT
// The result of methods that have nothing to say but that they are done.
#pragma once

#include <string_view>

namespace hedgehog::protocol {

/// {}
struct Done {
  static constexpr std::string_view kSchema = "Done";
  friend bool operator==(const Done&, const Done&) = default;
};

}  // namespace hedgehog::protocol
