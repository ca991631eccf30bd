// SPDX-License-Identifier: MIT
// Which role a client has: that of its token, or without one that of its transport.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "access/token_file.h"
#include "daemon/server/session/failed_tokens.h"
#include "daemon/server/session/session.h"
#include "protocol/wire/error.h"

namespace hedgehog::server {

/// io thread only.
class TokenCheck {
 public:
  void set_tokens(access::Tokens tokens) { tokens_ = std::move(tokens); }
  void set_simulated(bool simulated) noexcept { simulated_ = simulated; }

  /// Of a client without a token: all may do everything on the simulator, where nobody can be hurt,
  /// and on the Unix socket, which has permissions of its own. On TCP and WebSocket clients may
  /// play, and only observe once there is a token.
  protocol::Role role_without_token(std::string_view transport) const noexcept;

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
  bool simulated_ = false;
  FailedTokens failed_;
};

/// "unauthorized: send your token in hello", for a session that is `locked`.
protocol::RpcError token_needed();

}  // namespace hedgehog::server
