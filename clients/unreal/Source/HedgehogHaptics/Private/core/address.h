// SPDX-License-Identifier: MIT
// Address of the daemon.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace hedgehog::unreal {

struct Address {
  std::string host = "127.0.0.1";
  std::uint16_t port = 7586;
  /// Not empty: the address is invalid, one sentence.
  std::string error{};
};

/// "host", "host:port", "[v6]:port" or a bare IPv6 address, each optionally prefixed by "tcp:".
Address parse_address(std::string_view text);
/// `given`, or else HEDGEHOG_ADDRESS, or else 127.0.0.1:7586. Other clients try the daemon's Unix
/// sockets first, which Unreal's sockets do not support.
Address find_daemon(const std::string& given);
std::string to_string(const Address& address);

}  // namespace hedgehog::unreal
