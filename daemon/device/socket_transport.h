// SPDX-License-Identifier: MIT
// One end of a SOCK_SEQPACKET socket pair, whose other end a simulated board holds: packets keep
// their length and order, and the end of the other process is noticed.
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

  /// Waits until there is a packet or the other end is gone, `timeout_ms` at most; a signal
  /// begins that time anew. For boards and hosts that keep step with each other; those with a clock
  /// never wait.
  void wait(int timeout_ms) const noexcept;

 private:
  FileDescriptor socket_;
  bool open_ = true;
};

/// A connected pair, closed in child processes unless passed on, with buffers for a few frames
/// only: set-points that wait for long are worth nothing. Throws std::system_error.
std::pair<FileDescriptor, FileDescriptor> make_socket_pair();

}  // namespace hedgehog::device
