// SPDX-License-Identifier: MIT
// The transfers of one opened board: reading ones are always pending, frames to send use idle ones.
#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>

#include "daemon/device/board_core/frame.h"
#include "daemon/device/usb/usb_port.h"

namespace hedgehog::device {

enum class UsbFault : std::uint8_t { kNone, kStalled, kGone, kFailed };  // stops an exchange

/// One thread at a time. `send` and `receive` never wait and allocate nothing (libusb: a few bytes
/// per transfer); the others are not for the link thread.
class UsbExchange {
 public:
  explicit UsbExchange(std::unique_ptr<UsbPort> port) : port_(std::move(port)) {}

  void start() noexcept;  // starts reading

  /// False: every transfer is pending, or after an error.
  bool send(std::span<const std::uint8_t, board::kFrameSize> frame) noexcept;
  /// The next packet in the order of arrival: its length, 0: none. Skips empty ones, truncates
  /// longer ones to `packet`.
  std::size_t receive(std::span<std::uint8_t> packet) noexcept;
  UsbFault fault() const noexcept { return fault_; }  // the first since `start`

  /// Waits for the transfer of sent frames, at most `timeout`.
  void flush(std::chrono::milliseconds timeout) noexcept;
  /// Cancels all transfers. False: some did not end within `timeout`.
  bool cancel_all(std::chrono::milliseconds timeout) noexcept;
  /// Clears a stall and starts again. False: close it.
  bool recover(std::chrono::milliseconds timeout) noexcept;

  /// Transfers started and ended so far; equal when none is pending.
  std::uint64_t begun() const noexcept { return begun_; }
  std::uint64_t ended() const noexcept { return ended_; }

 private:
  void submit(int slot, std::size_t length) noexcept;
  std::size_t poll(std::chrono::milliseconds wait) noexcept;
  bool wait_for(int first, int last, std::chrono::milliseconds timeout) noexcept;
  bool none_of(int first, int last) const noexcept;
  void note(UsbFault fault) noexcept;

  struct Packet {
    int slot = 0;
    std::size_t length = 0;
  };

  std::unique_ptr<UsbPort> port_;
  std::array<bool, kSlots> submitted_{};
  std::array<Packet, kReadSlots> packets_{};  // read and not yet returned: at most one per slot
  std::size_t first_ = 0;
  std::size_t count_ = 0;
  UsbFault fault_ = UsbFault::kNone;
  std::uint64_t begun_ = 0;
  std::uint64_t ended_ = 0;
};

}  // namespace hedgehog::device
