// SPDX-License-Identifier: MIT
#include "daemon/device/socket_transport.h"

#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>

namespace hedgehog::device {

FileDescriptor::~FileDescriptor() {
  if (fd_ >= 0) ::close(fd_);
}

bool SocketTransport::send(std::span<const std::uint8_t, board::kFrameSize> frame) noexcept {
  const ssize_t sent =
      ::send(socket_.get(), frame.data(), frame.size(), MSG_DONTWAIT | MSG_NOSIGNAL);
  if (sent < 0 && errno != EAGAIN && errno != EWOULDBLOCK && errno != EINTR && errno != ENOBUFS)
    open_ = false;
  return sent == static_cast<ssize_t>(frame.size());
}

std::size_t SocketTransport::receive(std::span<std::uint8_t> packet) noexcept {
  const ssize_t got = ::recv(socket_.get(), packet.data(), packet.size(), MSG_DONTWAIT);
  if (got > 0) return static_cast<std::size_t>(got);
  if (got == 0 || (errno != EAGAIN && errno != EWOULDBLOCK && errno != EINTR)) open_ = false;
  return 0;
}

void SocketTransport::wait(int timeout_ms) const noexcept {
  pollfd readable{socket_.get(), POLLIN, 0};
  while (::poll(&readable, 1, timeout_ms) < 0 && errno == EINTR) {
  }
}

std::pair<FileDescriptor, FileDescriptor> make_socket_pair() {
  int ends[2];
  if (::socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, ends) != 0)
    throw std::system_error(errno, std::generic_category(), "socketpair");
  std::pair<FileDescriptor, FileDescriptor> pair{FileDescriptor(ends[0]), FileDescriptor(ends[1])};
  const int bytes = 16 * 1024;
  for (const int end : ends) ::setsockopt(end, SOL_SOCKET, SO_SNDBUF, &bytes, sizeof bytes);
  return pair;
}

}  // namespace hedgehog::device
