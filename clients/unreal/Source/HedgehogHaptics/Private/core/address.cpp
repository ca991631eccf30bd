// SPDX-License-Identifier: MIT
#include "core/address.h"

#include <cstdlib>

namespace hedgehog::unreal {

namespace {

Address bad(std::string_view text, const char* why) {
  Address none;
  none.error = "'" + std::string(text) + "' is no address of a daemon: " + why +
               " (for example 127.0.0.1:7586 or [::1]:7586)";
  return none;
}

/// The port of ":7586"; 0: invalid.
unsigned port_of(std::string_view text) {
  if (text.size() < 2 || text.size() > 6 || text.front() != ':') return 0;
  unsigned port = 0;
  for (const char c : text.substr(1)) {
    if (c < '0' || c > '9') return 0;
    port = port * 10 + static_cast<unsigned>(c - '0');
  }
  return port <= 65535 ? port : 0;
}

}  // namespace

Address parse_address(std::string_view text) {
  if (text.substr(0, 5) == "unix:" || text.substr(0, 1) == "/")
    return bad(text, "the plugin does not support Unix sockets");
  if (text.substr(0, 6) == "tls://" || text.substr(0, 7) == "mdns://") {
    const std::string why = "the plugin supports neither TLS nor discovery; hedgehogctl tunnel " +
                            std::string(text) + " makes it 127.0.0.1:7586";
    return bad(text, why.c_str());
  }
  const std::string_view place = text.substr(0, 4) == "tcp:" ? text.substr(4) : text;
  std::string_view host = place;
  std::string_view rest;
  const std::size_t colon = place.find(':');
  if (place.substr(0, 1) == "[") {
    const std::size_t close = place.find(']');
    if (close == std::string_view::npos) return bad(text, "']' is missing");
    host = place.substr(1, close - 1);
    rest = place.substr(close + 1);
  } else if (colon != std::string_view::npos && colon == place.rfind(':')) {
    host = place.substr(0, colon);
    rest = place.substr(colon);
  }
  if (host.empty()) return bad(text, "it names no host");
  Address address;
  address.host = std::string(host);
  if (rest.empty()) return address;
  const unsigned port = port_of(rest);
  if (port == 0) return bad(text, "the port is a number from 1 to 65535");
  address.port = static_cast<std::uint16_t>(port);
  return address;
}

Address find_daemon(const std::string& given) {
  if (!given.empty()) return parse_address(given);
  const char* const named = std::getenv("HEDGEHOG_ADDRESS");
  return named != nullptr && *named != '\0' ? parse_address(named) : Address{};
}

std::string to_string(const Address& address) {
  const bool v6 = address.host.find(':') != std::string::npos;
  return (v6 ? "[" + address.host + "]" : address.host) + ":" + std::to_string(address.port);
}

}  // namespace hedgehog::unreal
