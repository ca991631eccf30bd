// SPDX-License-Identifier: MIT
// A user, a group, or everybody, as named in the configuration.
#pragma once

#include <boost/system/result.hpp>
#include <cstdint>
#include <string>
#include <string_view>

#include "access/peer.h"

namespace hedgehog::access {

struct Principal {
  enum class Kind : std::uint8_t { kEverybody, kUser, kGroup };

  Kind kind = Kind::kEverybody;
  /// Id of the user or the group.
  std::uint32_t id = 0;
  /// As in the configuration: "*", "alice", "1000", "@users", "@100".
  std::string text{"*"};
  friend bool operator==(const Principal&, const Principal&) = default;
};

/// The principal named by `text`, or the error as one sentence without `text`. Names are looked up
/// in the system's databases (NSS), which may block on a disk or a network: start-up and reload
/// only. Any thread.
boost::system::result<Principal, std::string> parse_principal(std::string_view text);

/// Any thread; no lookup.
bool includes(const Principal& principal, const Peer& peer) noexcept;

}  // namespace hedgehog::access
