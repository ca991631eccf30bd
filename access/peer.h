// SPDX-License-Identifier: MIT
// The process at the other end of a Unix socket. Any thread.
#pragma once

#include <cstdint>
#include <vector>

namespace hedgehog::access {

/// Credentials as of its connect(2), in the daemon's namespaces. Source: unix(7), SO_PEERCRED and
/// SO_PEERGROUPS.
struct Peer {
  std::uint32_t user = 0;
  std::uint32_t group = 0;
  /// Its supplementary groups; `group` need not be among them.
  std::vector<std::uint32_t> groups{};
  /// 0: none in the daemon's PID namespace. The PID may have been reused since.
  std::int64_t process = 0;
  friend bool operator==(const Peer&, const Peer&) = default;
};

}  // namespace hedgehog::access
