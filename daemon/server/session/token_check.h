// SPDX-License-Identifier: MIT
// Which role a client has: that of its token, or without one that of its transport, on the Unix
// socket that of its user.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "access/token_file.h"
#include "access/unix_roles.h"
#include "daemon/server/session/failed_tokens.h"
#include "daemon/server/session/session.h"
#include "protocol/wire/error.h"

namespace hedgehog::server {

/// io thread only.
class TokenCheck {
 public:
  void set_tokens(access::Tokens tokens) { tokens_ = std::move(tokens); }
  /// `own_user`: the daemon's.
  void set_unix_roles(access::UnixRoles roles, std::uint32_t own_user) {
    unix_roles_ = std::move(roles);
    own_user_ = own_user;
  }
  void set_simulated(bool simulated) noexcept { simulated_ = simulated; }

  /// Of a client without a token. On the Unix socket that of its user, on the simulator too;
  /// nullopt: none. Elsewhere all may do everything on the simulator, where nobody can be hurt;
  /// else they may play, and only observe once there is a token.
  std::optional<protocol::Role> role_without_token(const Session& session) const noexcept;

  /// Gives a new `session` that role; without one it is locked. REQUIRES: its transport and peer
  /// are known.
  void admit(Session& session) const noexcept;
  /// Gives `session` the role of the token that it shows. Why not: `unauthorized`, at once while
  /// its address has to wait. The error has nothing of `secret`.
  std::optional<protocol::RpcError> log_in(Session& session, std::string_view secret,
                                           model::Tick now);
  /// Whether the token that `session` has shown is still good for the same role.
  bool is_valid(const Session& session) const noexcept;

 private:
  /// The token of that digest; looks at all of them, whichever it is.
  const access::Token* find(const access::Digest& digest) const noexcept;

  access::Tokens tokens_;
  access::UnixRoles unix_roles_;
  std::uint32_t own_user_ = 0;
  bool simulated_ = false;
  FailedTokens failed_;
};

/// What a session that is `locked` is answered: `unauthorized`, and what it can do about it.
protocol::RpcError token_needed(const Session& session);

}  // namespace hedgehog::server
