// SPDX-License-Identifier: MIT
// One end of a SOCK_SEQPACKET socket pair with a simulated board at the other end: packets keep
// their length and order, and the end of the other process is detected.
#pragma once

#include <system_error>
#include <utility>

#include "daemon/device/transport.h"

namespace hedgehog::device {

/// Owns a file descriptor.
class FileDescriptor {
 public:
  FileDescriptor() noexcept = default;
  explicit FileDescriptor(int fd) noexcept : fd_(fd) {}
  FileDescriptor(FileDescriptor&& other) noexcept : fd_(std::exchange(other.fd_, -1)) {}
  FileDescriptor& operator=(FileDescriptor&& other) noexcept {
    std::swap(fd_, other.fd_);
    return *this;
  }
  ~FileDescriptor();

  int get() const noexcept { return fd_; }
  int release() noexcept { return std::exchange(fd_, -1); }

 private:
  int fd_ = -1;
};

class SocketTransport final : public Transport {
 public:
  explicit SocketTransport(FileDescriptor socket) noexcept : socket_(std::move(socket)) {}

  bool send(std::span<const std::uint8_t, board::kFrameSize> frame) noexcept override;
  std::size_t receive(std::span<std::uint8_t> packet) noexcept override;
  bool open() const noexcept override { return open_; }

  /// Waits for a packet or the end of the peer, at most `timeout_ms`; a signal restarts the
  /// timeout. For boards and hosts in lock-step; those with a clock never wait.
  void wait(int timeout_ms) const noexcept;

 private:
  FileDescriptor socket_;
  bool open_ = true;
};

/// A connected pair, closed in child processes unless passed on, with buffers for only a few
/// frames, because old set-points are useless. Throws std::system_error.
std::pair<FileDescriptor, FileDescriptor> make_socket_pair();

}  // namespace hedgehog::device
