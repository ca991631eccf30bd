// SPDX-License-Identifier: MIT
#include "access/token_file.h"

#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <optional>

#include "base/atomic_file.h"
#include "base/regular_file.h"

namespace hedgehog::access {
namespace {

constexpr std::string_view kDigestPrefix = "sha256:";
constexpr std::string_view kAbout =
    "# Tokens of hedgehogd, by hedgehogctl token. Only digests: a token that is lost is "
    "replaced.\n";
constexpr mode_t kOwnerOnly = 0600;

/// Removes and returns the next word of `line`.
std::string_view take_word(std::string_view& line) {
  const std::size_t begin = std::min(line.find_first_not_of(" \t\r"), line.size());
  line.remove_prefix(begin);
  const std::size_t end = std::min(line.find_first_of(" \t\r"), line.size());
  const std::string_view word = line.substr(0, end);
  line.remove_prefix(end);
  return word;
}

std::optional<Token> parse_line(std::string_view line) {
  Token token;
  token.name = take_word(line);
  const auto role = protocol::role_named(take_word(line));
  std::string_view digest = take_word(line);
  token.made = take_word(line);
  if (!is_token_name(token.name) || !role || !digest.starts_with(kDigestPrefix) ||
      !take_word(line).empty())
    return std::nullopt;
  digest.remove_prefix(kDigestPrefix.size());
  const auto bytes = base::parse_sha256(digest);
  if (!bytes) return std::nullopt;
  token.role = *role;
  token.digest = {*bytes};
  return token;
}

}  // namespace

boost::system::result<Tokens, FileProblem> parse_tokens(std::string_view text) {
  Tokens tokens;
  for (int number = 1; !text.empty(); ++number) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    std::string_view rest = line;
    const std::string_view first = take_word(rest);
    if (first.empty() || first.front() == '#') continue;
    auto token = parse_line(line);
    // Without the line itself: a token written in place of its digest must not appear in a log.
    if (!token)
      return FileProblem{"must be NAME ROLE sha256:DIGEST DATE, as hedgehogctl token writes it",
                         number};
    if (find_token(tokens, token->name) != nullptr)
      return FileProblem{"there is a token " + token->name + " already", number};
    if (tokens.size() == kMaxTokens)
      return FileProblem{"there are more than " + std::to_string(kMaxTokens) + " tokens", number};
    tokens.push_back(*std::move(token));
  }
  return tokens;
}

std::string to_text(const Tokens& tokens) {
  std::string text(kAbout);
  for (const Token& token : tokens) {
    text += token.name + " " + std::string(protocol::name(token.role)) + " " +
            std::string(kDigestPrefix) + base::to_hex(token.digest.bytes) + " " + token.made + "\n";
  }
  return text;
}

boost::system::result<Tokens, FileProblem> read_tokens(const std::string& path) {
  const base::FileText file = base::read_regular_file(path, kMaxTokenFileBytes);
  if (file.missing) return Tokens{};
  if (!file.good()) return FileProblem{file.problem};
  return parse_tokens(file.text);
}

std::string write_secret_file(const std::string& path, std::string_view content) {
  if (std::string problem = base::write_file_atomically(path, content, kOwnerOnly);
      !problem.empty())
    return problem;
  struct stat folder {};
  const std::string parent = std::filesystem::path(path).parent_path();
  const bool known = ::stat(parent.empty() ? "." : parent.c_str(), &folder) == 0;
  const bool another = known && folder.st_uid != ::geteuid();
  if (another && ::geteuid() == 0 && ::lchown(path.c_str(), folder.st_uid, folder.st_gid) != 0)
    return path + ": " + std::strerror(errno);
  return {};
}

const Token* find_token(const Tokens& tokens, std::string_view name) noexcept {
  const auto found = std::find_if(tokens.begin(), tokens.end(),
                                  [&](const Token& token) { return token.name == name; });
  return found == tokens.end() ? nullptr : &*found;
}

}  // namespace hedgehog::access
