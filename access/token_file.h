// SPDX-License-Identifier: MIT
// The daemon's token file: one line per token, "NAME ROLE sha256:DIGEST 2026-11-24", and comment
// lines. Any thread; reading and writing may block on the disk.
#pragma once

#include <boost/system/result.hpp>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "access/token.h"

namespace hedgehog::access {

using Tokens = std::vector<Token>;

inline constexpr std::size_t kMaxTokens = 256;
inline constexpr std::size_t kMaxTokenFileBytes = std::size_t{64} * 1024;
/// File names in the daemon's state directory.
inline constexpr std::string_view kTokenFile = "tokens";
inline constexpr std::string_view kCertificateFile = "certificate.pem";
inline constexpr std::string_view kKeyFile = "key.pem";

/// Error in a file, one sentence. `line` 0: the whole file.
struct FileProblem {
  std::string reason;
  int line = 0;
};

boost::system::result<Tokens, FileProblem> parse_tokens(std::string_view text);
/// The inverse.
std::string to_text(const Tokens& tokens);

/// A file that does not exist has no tokens.
boost::system::result<Tokens, FileProblem> read_tokens(const std::string& path);
/// Replaces the file atomically, mode 0600. Its owner is that of its folder, so that the daemon can
/// read a file written by root. Returns an empty string, or the error.
std::string write_secret_file(const std::string& path, std::string_view content);

/// The token of that name; nullptr: none.
const Token* find_token(const Tokens& tokens, std::string_view name) noexcept;

}  // namespace hedgehog::access
