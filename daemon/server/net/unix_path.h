// SPDX-License-Identifier: MIT
// File-system path of a Unix socket, and the socket that listens there.
#pragma once

#include <boost/asio/io_context.hpp>
#include <boost/asio/local/stream_protocol.hpp>
#include <cstdint>
#include <string>

#include "access/unix_roles.h"

namespace hedgehog::server {

/// Makes room for a socket at `path`: its folder exists and belongs to us, and a socket that nobody
/// answers any more is removed. Throws std::runtime_error when somebody does answer, or when
/// something that is no socket is in the way.
void make_room_for_socket(const std::string& path);

/// Listens at `path`, as `make_room_for_socket` allows. The file has the mode 0660, or 0666 where
/// `roles` decide who may do what. Throws std::runtime_error with a sentence for a person.
boost::asio::local::stream_protocol::acceptor open_unix_acceptor(boost::asio::io_context& io,
                                                                 const std::string& path,
                                                                 const access::UnixRoles& roles);

/// Gives `path` that mode if it still is the file `inode`; false when the system refuses.
bool set_unix_mode(const std::string& path, std::uint64_t inode,
                   const access::UnixRoles& roles) noexcept;

/// 0 when there is nothing.
std::uint64_t inode_of(const std::string& path) noexcept;

/// Removes `path` if it still is the file `inode`: a later daemon may have taken the place.
void remove_if_ours(const std::string& path, std::uint64_t inode) noexcept;

}  // namespace hedgehog::server
