// SPDX-License-Identifier: MIT
// The protocol's definitions, and JSON for requests and reports.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "protocol/wire/json.h"
#include "tests/protocol/schema.h"

namespace hedgehog::soak {

/// protocol/schema/messages.schema.json, generated from the code.
inline const protocol::Json& message_definitions() {
  static const protocol::Json all = protocol::messages_schema();
  return all;
}

inline std::string json_string(std::string_view text) {
  std::string made;
  protocol::append_string(made, text);
  return made;
}

/// The beginning of a text that may be long.
inline std::string shortened(const std::string& text) {
  constexpr std::size_t kShown = 300;
  if (text.size() <= kShown) return text;
  return text.substr(0, kShown) + "... (" + std::to_string(text.size()) + " bytes)";
}
inline std::string shortened(const protocol::Json& json) {
  return shortened(protocol::to_text(json));
}

}  // namespace hedgehog::soak
