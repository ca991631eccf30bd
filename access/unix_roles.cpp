// SPDX-License-Identifier: MIT
#include "access/unix_roles.h"

#include <algorithm>
#include <utility>

namespace hedgehog::access {
namespace {

/// Linux reports this id for each user without a mapping in this user namespace (and for `nobody`).
constexpr std::uint32_t kUnmappedUser = 65534;

bool any_includes(const Principals& principals, const Peer* peer) noexcept {
  return std::any_of(
      principals.begin(), principals.end(),
      [&](const Principal& principal) {
        return peer != nullptr ? includes(principal, *peer)
                               : principal.kind == Principal::Kind::kEverybody;
      });
}

}  // namespace

bool has_everybody(const Principals& principals) noexcept {
  return any_includes(principals, nullptr);
}

std::optional<protocol::Role> role_of(const UnixRoles& roles, const Peer* peer,
                                      std::uint32_t own_user) noexcept {
  using protocol::Role;
  const bool is_own = peer != nullptr && peer->user == own_user && own_user != kUnmappedUser;
  if (is_own || (peer != nullptr && peer->user == 0)) return Role::kOperate;
  for (const auto& [role, principals] : {std::pair{Role::kOperate, &roles.operate},
                                         {Role::kPlay, &roles.play},
                                         {Role::kObserve, &roles.observe}})
    if (any_includes(*principals, peer)) return role;
  return std::nullopt;
}

}  // namespace hedgehog::access
