// SPDX-License-Identifier: MIT
// The transfers of one opened board: some that read are always under way, frames to send go into
// those that are idle.
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

/// What keeps an exchange from going on.
enum class UsbTrouble : std::uint8_t { kNone, kStalled, kGone, kFailed };

/// Used by one thread at a time. `send` and `receive` never wait and allocate nothing (libusb
/// itself allocates a few bytes for each transfer that it submits); the others are not for the link
/// thread.
class UsbExchange {
 public:
  explicit UsbExchange(std::unique_ptr<UsbPort> port) : port_(std::move(port)) {}

  /// Begins to read.
  void start() noexcept;

  /// False: every transfer is still under way, or there is trouble.
  bool send(std::span<const std::uint8_t, board::kFrameSize> frame) noexcept;
  /// The next packet, in the order in which they came: its length, 0 when there is none. An empty
  /// packet is left out, a longer one is cut to `packet`.
  std::size_t receive(std::span<std::uint8_t> packet) noexcept;
  /// The first that has happened since `start`.
  UsbTrouble trouble() const noexcept { return trouble_; }

  /// Lets frames that were sent go out, as long as they do within `patience`.
  void flush(std::chrono::milliseconds patience) noexcept;
  /// Cancels everything. False: something did not end within `patience`.
  bool cancel_all(std::chrono::milliseconds patience) noexcept;
  /// Ends a stall and starts again. False: close it.
  bool recover(std::chrono::milliseconds patience) noexcept;

  /// Transfers begun and ended so far; equal when nothing is under way.
  std::uint64_t begun() const noexcept { return begun_; }
  std::uint64_t ended() const noexcept { return ended_; }

 private:
  void submit(int slot, std::size_t length) noexcept;
  std::size_t poll(std::chrono::milliseconds wait) noexcept;
  bool wait_for(int first, int last, std::chrono::milliseconds patience) noexcept;
  bool none_of(int first, int last) const noexcept;
  void note(UsbTrouble trouble) noexcept;

  struct Packet {
    int slot = 0;
    std::size_t length = 0;
  };

  std::unique_ptr<UsbPort> port_;
  std::array<bool, kSlots> under_way_{};
  /// Read and not yet asked for: at most one a reading slot.
  std::array<Packet, kReadSlots> packets_{};
  std::size_t first_ = 0;
  std::size_t count_ = 0;
  UsbTrouble trouble_ = UsbTrouble::kNone;
  std::uint64_t begun_ = 0;
  std::uint64_t ended_ = 0;
};

}  // namespace hedgehog::device
