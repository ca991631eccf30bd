// SPDX-License-Identifier: MIT
// File-system path of a Unix socket.
#pragma once

#include <cstdint>
#include <string>

namespace hedgehog::server {

/// Makes room for a socket at `path`: its folder exists and belongs to us, and a socket that nobody
/// answers any more is removed. Throws std::runtime_error when somebody does answer, or when
/// something that is no socket is in the way.
void make_room_for_socket(const std::string& path);

/// 0 when there is nothing.
std::uint64_t inode_of(const std::string& path) noexcept;

/// Removes `path` if it still is the file `inode`: a later daemon may have taken the place.
void remove_if_ours(const std::string& path, std::uint64_t inode) noexcept;

}  // namespace hedgehog::server
