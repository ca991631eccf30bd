// SPDX-License-Identifier: MIT
// A USB host without a kernel: sends what vhci-hcd would write into the socket, and reads the
// responses.
#pragma once

#include <sys/socket.h>

#include <array>
#include <optional>
#include <vector>

#include "emulator/host_session.h"

namespace hedgehog::emulator {

class FakeHost {
 public:
  explicit FakeHost(EmulatedDevice& device) {
    int ends[2] = {-1, -1};
    (void)::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends);
    socket_ = device::FileDescriptor(ends[0]);
    session_.emplace(device, device::FileDescriptor(ends[1]));
  }

  struct Done {
    std::uint32_t command = 0;
    std::uint32_t sequence = 0;
    std::int32_t status = 0;
    std::uint32_t actual = 0;
    Bytes data;
  };

  /// Returns the transfer's number; its response is returned by `next`.
  std::uint32_t submit(bool in, std::uint8_t endpoint, std::uint32_t length, const Bytes& data = {},
                       const std::array<Byte, 8>& setup = {}) {
    Bytes bytes;
    for (const std::uint32_t word :
         {1u, ++sequence_, 0u, in ? 1u : 0u, std::uint32_t{endpoint}, 0u, length, 0u, 0u, 0u})
      put_u32(bytes, word);
    bytes.insert(bytes.end(), setup.begin(), setup.end());
    bytes.insert(bytes.end(), data.begin(), data.end());
    send(bytes);
    return sequence_;
  }

  std::uint32_t unlink(std::uint32_t target) {
    Bytes bytes;
    for (const std::uint32_t word : {2u, ++sequence_, 0u, 0u, 0u, target}) put_u32(bytes, word);
    bytes.resize(kTransferHead);
    send(bytes);
    return sequence_;
  }

  /// Nothing: no answer so far. REQUIRES: what was asked for with IN transfers is told to `next`.
  std::optional<Done> next(bool in = false) {
    Bytes head(kTransferHead);
    if (::recv(socket_.get(), head.data(), head.size(), MSG_DONTWAIT) != kTransferHead)
      return std::nullopt;
    Done done{device::big_u32(&head[0]),
              device::big_u32(&head[4]),
              static_cast<std::int32_t>(device::big_u32(&head[20])),
              device::big_u32(&head[24]),
              {}};
    if (in && done.actual > 0) {
      done.data.resize(done.actual);
      (void)::recv(socket_.get(), done.data.data(), done.data.size(), MSG_WAITALL);
    }
    return done;
  }

  Done control_in(std::uint8_t type, std::uint8_t request, std::uint16_t value, std::uint16_t index,
                  std::uint16_t length) {
    submit(true, 0, length, {}, setup(type, request, value, index, length));
    return next(true).value_or(Done{});
  }
  Done control_out(std::uint8_t type, std::uint8_t request, std::uint16_t value,
                   std::uint16_t index, const Bytes& data = {}) {
    const auto length = static_cast<std::uint16_t>(data.size());
    submit(false, 0, length, data, setup(type, request, value, index, length));
    return next().value_or(Done{});
  }
  Done write(std::uint8_t endpoint, const Bytes& data) {
    submit(false, endpoint, static_cast<std::uint32_t>(data.size()), data);
    return next().value_or(Done{});
  }
  /// Submits a transfer, runs the device for up to `timeout_ms`, and returns the response.
  std::optional<Done> read(std::uint8_t endpoint, int timeout_ms = 1) {
    submit(true, endpoint, 64);
    for (;; --timeout_ms) {
      if (auto done = next(true)) return done;
      if (timeout_ms <= 0) return std::nullopt;
      run(1);
    }
  }
  void run(int milliseconds) {
    for (int i = 0; i < milliseconds; ++i) {
      session_->device().step();
      session_->pump();
    }
  }

  HostSession& session() { return *session_; }
  void send(const Bytes& bytes) {
    (void)::send(socket_.get(), bytes.data(), bytes.size(), MSG_NOSIGNAL);
    session_->ready();
  }

 private:
  static std::array<Byte, 8> setup(std::uint8_t type, std::uint8_t request, std::uint16_t value,
                                   std::uint16_t index, std::uint16_t length) {
    const auto low = [](std::uint16_t n) { return static_cast<Byte>(n); };
    const auto high = [](std::uint16_t n) { return static_cast<Byte>(n >> 8); };
    return {type,       request,     low(value),  high(value),
            low(index), high(index), low(length), high(length)};
  }

  device::FileDescriptor socket_;
  std::optional<HostSession> session_;
  std::uint32_t sequence_ = 0;
};

}  // namespace hedgehog::emulator
