// SPDX-License-Identifier: MIT
// Role of a client of the Unix socket, by its user.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "access/peer.h"
#include "access/principal.h"
#include "protocol/wire/role.h"

namespace hedgehog::access {

using Principals = std::vector<Principal>;

/// A plain value; any thread. While `operate` contains everybody (default), access is limited by
/// the socket's group and mode; otherwise by these lists alone.
struct UnixRoles {
  Principals observe{};
  Principals play{};
  Principals operate{Principal{}};
  friend bool operator==(const UnixRoles&, const UnixRoles&) = default;
};

inline constexpr std::size_t kMaxPrincipals = 256;

bool has_everybody(const Principals& principals) noexcept;

/// The highest role whose list includes `peer`; `operate` for root and for `own_user`, that of the
/// daemon, unless it is `nobody`, the id of users of another namespace; nullopt: none. A peer
/// without known credentials (nullptr) has only the roles of everybody.
std::optional<protocol::Role> role_of(const UnixRoles& roles, const Peer* peer,
                                      std::uint32_t own_user) noexcept;

}  // namespace hedgehog::access
