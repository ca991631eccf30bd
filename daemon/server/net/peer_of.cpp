// SPDX-License-Identifier: MIT
#include "daemon/server/net/peer_of.h"

#include <sys/socket.h>

#include <cerrno>

#ifndef SO_PEERGROUPS
#define SO_PEERGROUPS 59  // asm-generic/socket.h
#endif

namespace hedgehog::server {
namespace {

constexpr std::size_t kUsualGroups = 32;

std::vector<std::uint32_t> groups_of(int descriptor) {
  std::vector<gid_t> groups(kUsualGroups);
  for (;;) {
    auto bytes = static_cast<socklen_t>(groups.size() * sizeof(gid_t));
    const int error =
        ::getsockopt(descriptor, SOL_SOCKET, SO_PEERGROUPS, groups.data(), &bytes) == 0 ? 0 : errno;
    const std::size_t count = bytes / sizeof(gid_t);
    // The groups are those at the connect(2), so the second attempt fits.
    const bool too_few = error == ERANGE && count > groups.size();
    if (error != 0 && !too_few) return {};
    groups.resize(count);
    if (!too_few) return {groups.begin(), groups.end()};
  }
}

}  // namespace

std::optional<access::Peer> peer_of(int descriptor) {
  ucred credentials{};
  socklen_t bytes = sizeof credentials;
  if (::getsockopt(descriptor, SOL_SOCKET, SO_PEERCRED, &credentials, &bytes) != 0 ||
      bytes != sizeof credentials)
    return std::nullopt;
  return access::Peer{credentials.uid, credentials.gid, groups_of(descriptor), credentials.pid};
}

}  // namespace hedgehog::server
