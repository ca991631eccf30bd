// SPDX-License-Identifier: MIT
// Role of a client: that of its token, else of its transport, on the Unix socket of its user.
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
  void set_tokens(access::Tokens tokens) {
    tokens_ = std::move(tokens);
    ++version_;
  }
  /// `own_user`: the daemon's.
  void set_unix_roles(access::UnixRoles roles, std::uint32_t own_user) {
    unix_roles_ = std::move(roles);
    own_user_ = own_user;
    ++version_;
  }
  void set_simulated(bool simulated) noexcept {
    simulated_ = simulated;
    ++version_;
  }

  /// Role without a token: on the Unix socket always the user's; nullopt: none. Elsewhere operate
  /// on the simulator, which cannot hurt a person; else play, or observe if a token is configured.
  std::optional<protocol::Role> role_without_token(const Session& session) const noexcept;

  /// Gives a new `session` that role, or locks it. REQUIRES: its transport and peer are known.
  void admit(Session& session) const noexcept;
  /// Gives `session` the role of the sent token. Returns an error: `unauthorized`, at once during
  /// the back-off of its address. The error does not contain `secret`.
  std::optional<protocol::RpcError> log_in(Session& session, std::string_view secret,
                                           model::Tick now);
  /// True if tokens and roles are those by which `session` got its role, or it was never admitted.
  bool is_current(const Session& session) const noexcept {
    return session.access_version == 0 || session.access_version == version_;
  }
  /// Gives a `session` without a token the present role of its transport. False: the connection has
  /// to end, because its token is no longer valid for the same role, or its user has another role.
  bool renew(Session& session) const noexcept;

 private:
  /// True if the token of `session` is still valid for the same role. REQUIRES: it has one.
  bool is_valid(const Session& session) const noexcept;
  /// The token with that digest; always compares all of them.
  const access::Token* find(const access::Digest& digest) const noexcept;

  access::Tokens tokens_;
  access::UnixRoles unix_roles_;
  std::uint32_t own_user_ = 0;
  bool simulated_ = false;
  std::uint64_t version_ = 1;  // counts the changes of the above
  FailedTokens failed_;
};

/// Response to a `locked` session: `unauthorized`, with the remedy.
protocol::RpcError token_needed(const Session& session);

}  // namespace hedgehog::server
