// SPDX-License-Identifier: MIT
// Where the daemon listens.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace hedgehog::unreal {

struct Address {
  std::string host = "127.0.0.1";
  std::uint16_t port = 7586;
  /// Not empty: this is none, in one sentence.
  std::string error{};
};

/// "host", "host:port", "[v6]:port" or a bare IPv6 address, each with "tcp:" in front or without.
Address parse_address(std::string_view text);
/// `given`, or else HEDGEHOG_ADDRESS, or else 127.0.0.1:7586. Other clients look at the daemon's
/// Unix sockets first; Unreal's sockets have none.
Address find_daemon(const std::string& given);
std::string to_string(const Address& address);

}  // namespace hedgehog::unreal
