// SPDX-License-Identifier: MIT
// Where a listener waits.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include <boost/system/result.hpp>

namespace hedgehog::config {

struct ListenAddress {
  /// A numeric IPv4 or IPv6 address, the latter without brackets.
  std::string host;
  /// 0: any free one, printed when bound.
  std::uint16_t port = 0;
  friend bool operator==(const ListenAddress&, const ListenAddress&) = default;
};

struct AddressError {
  std::string reason;
};

/// "127.0.0.1:7586" or "[::1]:7586". The error is a reason for people. Addresses that other
/// machines can reach are refused: as long as there are neither tokens nor TLS, whoever reaches the
/// port may play.
boost::system::result<ListenAddress, AddressError> parse_listen_address(std::string_view text);

/// The inverse.
std::string to_string(const ListenAddress& address);

}  // namespace hedgehog::config
