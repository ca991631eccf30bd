// SPDX-License-Identifier: MIT
#include "daemon/server/session/token_check.h"

namespace hedgehog::server {

protocol::Role TokenCheck::role_without_token(std::string_view transport) const noexcept {
  using protocol::Role;
  if (simulated_ || transport == "unix") return Role::kOperate;
  return tokens_.empty() ? Role::kPlay : Role::kObserve;
}

std::optional<protocol::RpcError> TokenCheck::log_in(Session& session, std::string_view secret,
                                                     model::Tick now) {
  using protocol::ErrorCode;
  // Who may open the Unix socket is known by the system.
  const std::string key = session.address ? FailedTokens::key_of(*session.address) : "";
  if (const model::Tick wait = key.empty() ? 0 : failed_.remaining(key, now); wait > 0) {
    auto error = protocol::error(ErrorCode::kUnauthorized,
                                 "token: too many wrong ones came from this address; wait");
    error.field = "token";
    error.retry_after_ms = wait;
    return error;
  }
  const access::Digest digest = access::digest_of(secret);
  const access::Token* token = find(digest);
  if (token == nullptr) {
    if (!key.empty()) failed_.failed(key, now);
    auto error = protocol::error(ErrorCode::kUnauthorized, "token: it is not known here");
    error.field = "token";
    return error;
  }
  if (!key.empty()) failed_.succeeded(key);
  session.role = token->role;
  session.token = *token;
  session.locked = false;
  return std::nullopt;
}

bool TokenCheck::is_valid(const Session& session) const noexcept {
  if (!session.token) return true;
  const access::Token* token = find(session.token->digest);
  return token != nullptr && token->role == session.token->role;
}

const access::Token* TokenCheck::find(const access::Digest& digest) const noexcept {
  const access::Token* found = nullptr;
  for (const access::Token& token : tokens_)
    if (access::is_same(token.digest, digest)) found = &token;
  return found;
}

protocol::RpcError token_needed() {
  auto error = protocol::error(protocol::ErrorCode::kUnauthorized,
                               "unauthorized: send a token in hello first, or as HTTP's "
                               "Authorization: Bearer");
  error.role_needed = protocol::Role::kObserve;
  return error;
}

}  // namespace hedgehog::server
