// SPDX-License-Identifier: MIT
#include "daemon/server/net/unix_path.h"

#include <fcntl.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <stdexcept>

namespace hedgehog::server {
namespace {

bool has_listener(const std::string& path) {
  sockaddr_un address{};
  if (path.size() >= sizeof address.sun_path)
    throw std::runtime_error(path + ": longer than the 107 bytes of a socket's path");
  address.sun_family = AF_UNIX;
  std::memcpy(address.sun_path, path.c_str(), path.size() + 1);
  const int fd = ::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
  if (fd < 0) throw std::runtime_error(path + ": " + std::strerror(errno));
  const int result = ::connect(fd, reinterpret_cast<const sockaddr*>(&address), sizeof address);
  const int error = errno;
  ::close(fd);
  // EAGAIN: the backlog is full, so a server is listening.
  return result == 0 || (error != ECONNREFUSED && error != ENOENT);
}

/// A user with write access to the folder could replace the socket.
void require_private(const std::filesystem::path& folder) {
  struct stat s {};
  if (::lstat(folder.c_str(), &s) != 0 || !S_ISDIR(s.st_mode) ||
      (s.st_uid != ::geteuid() && s.st_uid != 0) ||
      ((s.st_mode & S_IWOTH) != 0 && (s.st_mode & S_ISVTX) == 0))
    throw std::runtime_error(folder.string() +
                             ": not a folder, or controlled by another user; not used for sockets");
}

mode_t unix_mode(const access::UnixRoles& roles) noexcept {
  return access::has_everybody(roles.operate) ? 0660 : 0666;
}

}  // namespace

void prepare_socket_path(const std::string& path) {
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  std::error_code ec;
  if (std::filesystem::create_directories(folder, ec)) ::chmod(folder.c_str(), 0750);
  if (ec) throw std::runtime_error(folder.string() + ": " + ec.message());
  require_private(folder);
  struct stat s {};
  if (::lstat(path.c_str(), &s) != 0) return;
  if (!S_ISSOCK(s.st_mode)) throw std::runtime_error(path + ": exists and is not a socket");
  if (has_listener(path)) throw std::runtime_error(path + ": another hedgehogd is running there");
  ::unlink(path.c_str());
}

boost::asio::local::stream_protocol::acceptor open_unix_acceptor(boost::asio::io_context& io,
                                                                 const std::string& path,
                                                                 const access::UnixRoles& roles) {
  using Socket = boost::asio::local::stream_protocol;
  prepare_socket_path(path);
  const mode_t before = ::umask(0777 & ~unix_mode(roles));  // from its creation on
  Socket::acceptor acceptor(io);
  boost::system::error_code ec;
  acceptor.open(Socket(), ec);
  if (!ec) acceptor.bind(Socket::endpoint(path), ec);
  ::umask(before);
  if (!ec) {
    const std::uint64_t inode = inode_of(path);
    acceptor.listen(boost::asio::socket_base::max_listen_connections, ec);
    if (ec) remove_own_socket(path, inode);
  }
  if (ec) throw std::runtime_error(path + ": " + ec.message());
  return acceptor;
}

bool set_unix_mode(const std::string& path, std::uint64_t inode,
                   const access::UnixRoles& roles) noexcept {
  return path.empty() || inode_of(path) != inode || ::chmod(path.c_str(), unix_mode(roles)) == 0;
}

std::uint64_t inode_of(const std::string& path) noexcept {
  struct stat s {};
  return ::lstat(path.c_str(), &s) == 0 ? s.st_ino : 0;
}

void remove_own_socket(const std::string& path, std::uint64_t inode) noexcept {
  if (inode != 0 && inode_of(path) == inode) ::unlink(path.c_str());
}

}  // namespace hedgehog::server
