// SPDX-License-Identifier: MIT
// Tokens: random secrets presented by clients; the daemon stores only digests. Any thread.
#pragma once

#include <string>
#include <string_view>

#include "base/digest_text.h"
#include "protocol/wire/role.h"

namespace hedgehog::access {

/// SHA-256 of a token, without salt or a slow hash: a token has 256 random bits, so that dictionary
/// attacks are infeasible and no two tokens have the same digest.
struct Digest {
  base::Sha256 bytes{};
  /// Takes the same time wherever they differ.
  friend bool operator==(const Digest& a, const Digest& b) noexcept;
};

/// Stored data of a token.
struct Token {
  /// 1..32 letters, digits, "-", "_", "."; unique.
  std::string name{};
  protocol::Role role = protocol::Role::kObserve;
  Digest digest{};
  /// "2026-11-24".
  std::string made{};
  friend bool operator==(const Token&, const Token&) = default;
};

/// "hht_" and 256 random bits in base64url. Throws std::runtime_error when the system has no random
/// numbers.
std::string new_token();

/// Throws std::runtime_error when OpenSSL has no SHA-256.
Digest digest_of(std::string_view text);

bool is_token_name(std::string_view text) noexcept;

}  // namespace hedgehog::access
