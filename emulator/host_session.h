// SPDX-License-Identifier: MIT
// USB/IP session of one host with one plugged-in device, over a stream socket.
#pragma once

#include <deque>
#include <map>
#include <vector>

#include "daemon/device/socket_transport.h"
#include "emulator/emulated_device.h"

namespace hedgehog::emulator {

/// The emulator's thread. Never blocks.
class HostSession {
 public:
  /// `socket`: after the import, or one end of a pair whose other end belongs to vhci-hcd. `device`
  /// must outlive this; the constructor plugs it in.
  HostSession(EmulatedDevice& device, device::FileDescriptor socket);

  int fd() const noexcept { return socket_.get(); }
  /// True if the socket's buffer is full: poll must also wait for POLLOUT.
  bool blocked() const noexcept { return !unsent_.empty(); }
  bool open() const noexcept { return open_; }
  EmulatedDevice& device() noexcept { return device_; }

  /// To be called when the socket is readable or writable.
  void ready();
  /// Completes pending reads for which a packet is queued; stalls those of a halted endpoint.
  void pump();

 private:
  struct Transfer {
    std::uint32_t sequence = 0;
    std::uint32_t length = 0;
    Bytes data;
  };
  bool take_message();
  void handle(const HostMessage& message, Bytes data);
  void control(const HostMessage& message, const Bytes& data);
  void unlink(const HostMessage& message);
  void answer_reads(std::uint8_t endpoint, std::deque<Transfer>& reads);
  void answer_writes(std::uint8_t endpoint, std::deque<Transfer>& writes);
  void send(const Bytes& bytes);
  void flush();

  EmulatedDevice& device_;
  device::FileDescriptor socket_;
  bool open_ = true;
  Bytes received_;
  Bytes unsent_;
  /// Pending transfers by endpoint number.
  std::map<std::uint8_t, std::deque<Transfer>> reads_;
  std::map<std::uint8_t, std::deque<Transfer>> writes_;
};

}  // namespace hedgehog::emulator
