// SPDX-License-Identifier: MIT
// Which role a client of the Unix socket has, by the user that runs it.
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

/// A plain value; any thread. While `operate` has everybody, which is the default, that is
/// everybody whom the socket's group and mode let in; otherwise these lists alone decide.
struct UnixRoles {
  Principals observe{};
  Principals play{};
  Principals operate{Principal{}};
  friend bool operator==(const UnixRoles&, const UnixRoles&) = default;
};

inline constexpr std::size_t kMaxPrincipals = 256;

bool has_everybody(const Principals& principals) noexcept;

/// The highest role whose list includes `peer`; `operate` for root and for `own_user`, that of the
/// daemon, unless that is `nobody`, as users of another namespace are shown; nullopt: none. A peer
/// whose credentials the system does not tell (nullptr) has the roles of everybody only.
std::optional<protocol::Role> role_of(const UnixRoles& roles, const Peer* peer,
                                      std::uint32_t own_user) noexcept;

}  // namespace hedgehog::access
