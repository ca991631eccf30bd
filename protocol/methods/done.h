// SPDX-License-Identifier: MIT
// The empty result, for methods that only confirm completion.
#pragma once

#include <string_view>

namespace hedgehog::protocol {

/// {}
struct Done {
  static constexpr std::string_view kSchema = "Done";
  friend bool operator==(const Done&, const Done&) = default;
};

}  // namespace hedgehog::protocol
