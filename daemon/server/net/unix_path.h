// SPDX-License-Identifier: MIT
// File-system path of a Unix socket, and the socket that listens there.
#pragma once

#include <boost/asio/io_context.hpp>
#include <boost/asio/local/stream_protocol.hpp>
#include <cstdint>
#include <string>

#include "access/unix_roles.h"

namespace hedgehog::server {

/// Creates the folder of `path`, which must belong to this user or root, and removes a socket
/// without a server. Throws std::runtime_error if a server listens or the file is not a socket.
void prepare_socket_path(const std::string& path);

/// The same, and listens at `path` with mode 0660, or 0666 if `roles` decide on access. Throws
/// std::runtime_error with a sentence for display.
boost::asio::local::stream_protocol::acceptor open_unix_acceptor(boost::asio::io_context& io,
                                                                 const std::string& path,
                                                                 const access::UnixRoles& roles);

/// Sets that mode of `path` if it still is the file `inode`; false on failure.
bool set_unix_mode(const std::string& path, std::uint64_t inode,
                   const access::UnixRoles& roles) noexcept;

std::uint64_t inode_of(const std::string& path) noexcept;  // 0: no file

/// Removes `path` if it still is the file `inode`: a later daemon may have replaced it.
void remove_own_socket(const std::string& path, std::uint64_t inode) noexcept;

}  // namespace hedgehog::server
