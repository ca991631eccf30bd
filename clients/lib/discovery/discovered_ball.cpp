// SPDX-License-Identifier: MIT
#include "clients/lib/discovery/discovered_ball.h"

#include "protocol/wire/json.h"

namespace hedgehog::client {

std::string printable(std::string_view text) {
  std::string plain(text);
  for (char& c : plain)
    if (static_cast<unsigned char>(c) < 0x20u || c == '\x7f') c = '?';
  // The JSON encoder replaces invalid UTF-8.
  std::string json;
  protocol::append_string(json, plain);
  const auto read = protocol::parse_json(json, 1);
  const auto* replaced = read ? std::get_if<std::string>(&read->value) : nullptr;
  plain = replaced != nullptr ? *replaced : std::string();
  // C1 control characters are C2 80 to C2 9F in UTF-8.
  for (std::size_t i = 0; i + 1 < plain.size(); ++i)
    if (plain[i] == '\xc2' && static_cast<unsigned char>(plain[i + 1]) < 0xa0u)
      plain.replace(i, 2, "?");
  return plain;
}

}  // namespace hedgehog::client
