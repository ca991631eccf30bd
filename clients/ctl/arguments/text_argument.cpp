// SPDX-License-Identifier: MIT
#include "clients/ctl/arguments/text_argument.h"

#include <nlohmann/json.hpp>

namespace hedgehog::client {

Outcome<std::string> text_json(const std::string& name, const std::string& text) {
  using nlohmann::json;
  const std::string quoted = json(text).dump(-1, ' ', false, json::error_handler_t::replace);
  if (json::parse(quoted).get<std::string>() != text)
    return ClientError{Failure::kBadAddress, name + ": is not UTF-8", {}};
  return quoted;
}

}  // namespace hedgehog::client
