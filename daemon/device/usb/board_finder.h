// SPDX-License-Identifier: MIT
// Finds, opens, recovers and closes the board, and lends its transfers to the link thread: contains
// every blocking operation, so that the link never blocks.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "daemon/device/usb/board_choice.h"
#include "daemon/device/usb/usb_exchange.h"
#include "daemon/device/usb/usb_port.h"

namespace hedgehog::device {

/// The board as a USB device.
struct BoardUsbInfo {
  bool open = false;              // with this protocol version
  bool seen = false;              // a device with its ids is connected, used or not
  std::string what;               // name of the open board, or the reason for which none is open
  std::optional<UsbPlace> place;  // of the open board
  std::optional<std::string> serial;  // from its descriptors
  std::optional<std::string> firmware;
  std::uint64_t opened = 0;  // number of times
  std::uint64_t closed = 0;
  std::uint64_t recovered = 0;  // from a stall
};

/// One object, two threads. The exchange belongs to finder and link in turns; only its present
/// owner uses it. The link returns it on an error.
class BoardFinder {
 public:
  using Milliseconds = std::chrono::milliseconds;
  static constexpr Milliseconds kCheckPeriod{20};  // interval of the checks of an open board
  /// Pauses between attempts to find a board, doubling; longer if it cannot be opened or fails.
  static constexpr Milliseconds kFirstPause{250};
  static constexpr Milliseconds kLongestPause{1000};
  static constexpr Milliseconds kLongestPauseAfterFailure{8000};  // not after unplugging
  static constexpr Milliseconds kSilence{2000};  // then an open board is closed and opened again
  /// In a row, each within 10 s of the previous one; after more the board is reopened.
  static constexpr int kMaxStalls = 5;

  BoardFinder(UsbBus& bus, BoardIds wanted) : bus_(bus), board_ids_(std::move(wanted)) {}

  /// The finder's thread: does the work due at `now`, by a monotonic clock. Returns the time within
  /// which it has to be called again. May wait briefly for the device.
  Milliseconds step(Milliseconds now);
  void close();  // REQUIRES: the link no longer uses the board
  const BoardUsbInfo& usb_info() const noexcept { return usb_info_; }  // the finder's thread

  /// The link's thread; never waits:
  bool send(std::span<const std::uint8_t, board::kFrameSize> frame) noexcept;
  std::size_t receive(std::span<std::uint8_t> packet) noexcept;
  bool idle() const noexcept { return turn_.load(std::memory_order_relaxed) == Turn::kFinder; }

 private:
  enum class Turn : std::uint8_t { kFinder, kLink };

  void scan(Milliseconds now);
  void watch(Milliseconds now);
  void on_returned(Milliseconds now);
  void hand_to_link(Milliseconds now) noexcept;
  void close_failed(const std::string& why, Milliseconds longest, Milliseconds now);
  void clear_board();
  void fail(const std::string& why, Milliseconds longest, Milliseconds now);
  void check_version(std::span<const std::uint8_t> packet) noexcept;

  UsbBus& bus_;
  BoardIds board_ids_;
  BoardUsbInfo usb_info_;
  std::string name_;
  std::unique_ptr<UsbExchange> exchange_;
  Milliseconds next_{0};
  Milliseconds backoff_{kFirstPause};
  Milliseconds opened_at_{0};
  Milliseconds received_at_{0};
  Milliseconds stalled_at_{0};
  int stalls_ = 0;
  std::uint32_t last_packets_ = 0;

  std::atomic<Turn> turn_{Turn::kFinder};
  std::atomic<bool> return_requested_{false};
  std::atomic<std::uint32_t> packets_{0};
  std::atomic<std::uint8_t> foreign_version_{0};  // of received frames; 0: none
};

}  // namespace hedgehog::device
