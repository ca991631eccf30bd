// SPDX-License-Identifier: MIT
#include "access/principal.h"

#include <grp.h>
#include <pwd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <optional>
#include <vector>

namespace hedgehog::access {
namespace {

/// Large, because a group's entry contains the names of all its members.
constexpr std::size_t kFirstEntryBytes = 4096;
constexpr std::size_t kMaxEntryBytes = std::size_t{1} << 20;
constexpr std::size_t kMaxNameBytes = 256;
/// (uid_t)-1 and (gid_t)-1 are invalid.
constexpr std::uint32_t kInvalidId = 0xffffffff;

using Id = boost::system::result<std::uint32_t, std::string>;

/// `look`: getpwnam_r or getgrnam_r. `id`: returns the id of an entry.
template <class Entry, class Look, class GetId>
Id id_named(const std::string& name, const char* what, Look look, GetId id) {
  std::vector<char> bytes(kFirstEntryBytes);
  for (;;) {
    Entry entry{};
    Entry* found = nullptr;
    const int error = look(name.c_str(), &entry, bytes.data(), bytes.size(), &found);
    if (found != nullptr) return id(entry);
    if (error == EINTR) continue;
    if (error == ERANGE && bytes.size() < kMaxEntryBytes) {
      bytes.resize(bytes.size() * 2);
      continue;
    }
    // These errors also occur for names that do not exist: getpwnam_r(3).
    const bool missing =
        error == 0 || error == ENOENT || error == ESRCH || error == EBADF || error == EPERM;
    if (missing) return std::string("there is no such ") + what;
    return std::string("the ") + what + " cannot be looked up: " + std::strerror(error);
  }
}

std::optional<std::uint32_t> parse_id(std::string_view text) {
  std::uint32_t id = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), id);
  if (error != std::errc{} || end != text.data() + text.size() || id == kInvalidId)
    return std::nullopt;
  return id;
}

Id id_of(std::string_view name, bool is_group) {
  if (std::all_of(name.begin(), name.end(), [](char c) { return c >= '0' && c <= '9'; })) {
    if (const auto id = parse_id(name)) return *id;
    return std::string("a number must be at most 4294967294");
  }
  if (is_group)
    return id_named<group>(
        std::string(name), "group", ::getgrnam_r, [](const group& entry) { return entry.gr_gid; });
  return id_named<passwd>(std::string(name), "user", ::getpwnam_r,
                          [](const passwd& entry) { return entry.pw_uid; });
}

}  // namespace

boost::system::result<Principal, std::string> parse_principal(std::string_view text) {
  if (text == "*") return Principal{};
  const bool is_group = text.starts_with('@');
  const std::string_view name = text.substr(is_group ? 1 : 0);
  const bool possible =
      !name.empty() && name.size() <= kMaxNameBytes &&
      std::none_of(name.begin(), name.end(), [](char c) {
        const auto byte = static_cast<unsigned char>(c);
        return byte <= 0x20 || byte == 0x7f || c == ':' || c == '*' || c == '@' || c == ',';
      });
  if (!possible) return std::string(R"(must be a user "alice", a group "@users", or "*")");
  const auto id = id_of(name, is_group);
  if (!id) return id.error();
  return Principal{is_group ? Principal::Kind::kGroup : Principal::Kind::kUser, *id,
                   std::string(text)};
}

bool includes(const Principal& principal, const Peer& peer) noexcept {
  switch (principal.kind) {
    case Principal::Kind::kEverybody:
      return true;
    case Principal::Kind::kUser:
      return principal.id == peer.user;
    case Principal::Kind::kGroup:
      return principal.id == peer.group ||
             std::find(peer.groups.begin(), peer.groups.end(), principal.id) != peer.groups.end();
  }
  return false;
}

}  // namespace hedgehog::access
