// SPDX-License-Identifier: MIT
// Runs this test as another user of the machine, as the kernel reports it to a Unix socket's peer.
#pragma once

#include <grp.h>
#include <unistd.h>

#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "tests/e2e/daemon_process.h"

namespace hedgehog::e2e {

/// Users and a group that every Debian has.
inline constexpr uid_t kBinUser = 2;
inline constexpr uid_t kGamesUser = 5;
inline constexpr uid_t kNobodyUser = 65534;
inline constexpr gid_t kUsersGroup = 100;

/// Changes the effective user and groups of this process for its lifetime. REQUIRES: root.
class OtherUser {
 public:
  explicit OtherUser(uid_t user, const std::vector<gid_t>& groups = {}) {
    if (::setgroups(groups.size(), groups.data()) != 0 || ::setegid(kNobodyUser) != 0 ||
        ::seteuid(user) != 0)
      throw std::runtime_error("this process cannot become another user");
  }
  OtherUser(const OtherUser&) = delete;
  OtherUser& operator=(const OtherUser&) = delete;
  ~OtherUser() {
    const bool back = ::seteuid(0) == 0 && ::setegid(0) == 0 && ::setgroups(0, nullptr) == 0;
    if (!back) std::terminate();
  }
};

/// Grants all users access to the folder of sockets in `home`.
inline void open_to_all_users(const Home& home) {
  namespace fs = std::filesystem;
  for (const std::string below : {"", "run", "run/hedgehog"})
    fs::permissions(home.path(below), fs::perms::others_exec, fs::perm_options::add);
}

}  // namespace hedgehog::e2e
