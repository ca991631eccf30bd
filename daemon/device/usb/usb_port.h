// SPDX-License-Identifier: MIT
// Interface between the board's transport and libusb: a claimed interface with a fixed number of
// transfers, and the bus that opens it. Implemented by libusb_port and by tests.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "daemon/device/sensors/discovery.h"

namespace hedgehog::device {

/// Transfers of one port, by number: reading ones first, then writing ones.
inline constexpr int kReadSlots = 16;
inline constexpr int kWriteSlots = 8;
inline constexpr int kSlots = kReadSlots + kWriteSlots;
inline constexpr std::size_t kSlotBytes = 512;  // maximum packet of a bulk endpoint

enum class TransferEnd : std::uint8_t { kDone, kCancelled, kStalled, kGone, kFailed };

struct Completion {
  int slot = 0;
  TransferEnd end = TransferEnd::kDone;
  std::size_t length = 0;
};

/// One thread at a time. Destroying it cancels pending transfers, then closes the device.
class UsbPort {
 public:
  UsbPort() = default;
  UsbPort(const UsbPort&) = delete;
  UsbPort& operator=(const UsbPort&) = delete;
  virtual ~UsbPort() = default;

  virtual std::span<std::uint8_t, kSlotBytes> buffer(int slot) noexcept = 0;
  /// Starts a transfer; a reading slot uses its whole buffer, whatever `length` is. Never waits.
  /// False: it did not start, and no completion follows. REQUIRES: the slot is idle.
  virtual bool submit(int slot, std::size_t length) noexcept = 0;
  virtual void cancel(int slot) noexcept = 0;  // the completion still follows
  /// Ended transfers, oldest first; each once. Waits up to `wait` for the first.
  virtual std::size_t poll(std::span<Completion> ended,
                           std::chrono::milliseconds wait) noexcept = 0;
  /// Clears the stall of both endpoints. May wait for the device; not for the link thread.
  /// REQUIRES: no transfer is pending.
  virtual bool clear_halt() noexcept = 0;
};

class UsbBus {  // USB of this machine
 public:
  virtual ~UsbBus() = default;
  virtual std::vector<UsbDevice> list() = 0;
  /// Opens and claims the interface at `place`. Null on failure, with the reason in `failure`.
  virtual std::unique_ptr<UsbPort> open(const UsbPlace& place, std::string& failure) = 0;
};

}  // namespace hedgehog::device
