// SPDX-License-Identifier: MIT
// The id that associates a response with its request.
#pragma once

#include <cstdint>
#include <string>

namespace hedgehog::protocol {

/// A string, a number or null, stored as JSON text, so that it is returned unchanged.
struct Id {
  std::string json{"null"};

  static Id number(std::int64_t value) { return {std::to_string(value)}; }
  friend bool operator==(const Id&, const Id&) = default;
};

}  // namespace hedgehog::protocol
