// SPDX-License-Identifier: MIT
#include "daemon/server/session/token_check.h"

#include "daemon/server/session/origin.h"

namespace hedgehog::server {
namespace {

/// Key by which wrong tokens are counted: host or network, on the Unix socket the user; empty: not
/// counted.
std::string counted_key(const Session& session) {
  if (session.address) return FailedTokens::key_of(*session.address);
  return session.peer ? user_text(*session.peer) : "";
}

}  // namespace

std::optional<protocol::Role> TokenCheck::role_without_token(
    const Session& session) const noexcept {
  using protocol::Role;
  if (session.transport == "unix")
    return access::role_of(unix_roles_, session.peer ? &*session.peer : nullptr, own_user_);
  if (simulated_) return Role::kOperate;
  return tokens_.empty() ? Role::kPlay : Role::kObserve;
}

void TokenCheck::admit(Session& session) const noexcept {
  const auto role = role_without_token(session);
  session.role = role.value_or(protocol::Role::kObserve);
  session.locked = !role;
  session.access_version = version_;
}

std::optional<protocol::RpcError> TokenCheck::log_in(Session& session, std::string_view secret,
                                                     model::Tick now) {
  using protocol::ErrorCode;
  const std::string key = counted_key(session);
  if (const model::Tick wait = key.empty() ? 0 : failed_.remaining(key, now); wait > 0) {
    auto error =
        protocol::error(ErrorCode::kUnauthorized,
                        "token: too many invalid tokens from this address or user; retry later");
    error.field = "token";
    error.retry_after_ms = wait;
    return error;
  }
  const access::Digest digest = access::digest_of(secret);
  const access::Token* token = find(digest);
  if (token == nullptr) {
    if (!key.empty()) failed_.failed(key, now);
    auto error = protocol::error(ErrorCode::kUnauthorized, "token: unknown or revoked");
    error.field = "token";
    return error;
  }
  if (!key.empty()) failed_.succeeded(key);
  session.role = token->role;
  session.token = *token;
  session.locked = false;
  session.access_version = version_;
  return std::nullopt;
}

bool TokenCheck::renew(Session& session) const noexcept {
  session.access_version = version_;
  const bool on_unix_socket = session.transport == "unix";
  if (session.token) return is_valid(session);
  if (session.locked && !on_unix_socket) return true;
  const auto role = role_without_token(session);
  if (on_unix_socket) return role == (session.locked ? std::nullopt : std::optional(session.role));
  session.role = *role;
  return true;
}

bool TokenCheck::is_valid(const Session& session) const noexcept {
  const access::Token* token = find(session.token->digest);
  return token != nullptr && token->role == session.token->role;
}

const access::Token* TokenCheck::find(const access::Digest& digest) const noexcept {
  const access::Token* found = nullptr;
  for (const access::Token& token : tokens_)
    if (token.digest == digest) found = &token;
  return found;
}

protocol::RpcError token_needed(const Session& session) {
  std::string message;
  if (session.ended)
    message = "this connection has ended, because its token or role is no longer valid";
  else if (session.transport == "unix")
    message = (session.peer ? user_text(*session.peer) : "this user") +
              " has no role in access.unix of the configuration; send a token in hello first";
  else
    message = "send a token in hello first, or as HTTP's Authorization: Bearer";
  auto error = protocol::error(protocol::ErrorCode::kUnauthorized, "unauthorized: " + message);
  error.role_needed = protocol::Role::kObserve;
  return error;
}

}  // namespace hedgehog::server
