// SPDX-License-Identifier: MIT
// Finds, opens, recovers and closes the board, and lends its transfers to the link thread in
// between: everything that may block, so that the link never does.
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
  /// It is open, and speaks our version of the protocol.
  bool open = false;
  /// Something with its ids is connected, used or not.
  bool seen = false;
  /// What is open, or why nothing is.
  std::string what;
  /// Where the one that is open hangs.
  std::optional<UsbPlace> place;
  /// Of the one that is open, as it says of itself; nullopt: it does not.
  std::optional<std::string> serial;
  std::optional<std::string> firmware;
  /// Times that it was opened, closed, and mended after a stall, so far.
  std::uint64_t opened = 0;
  std::uint64_t closed = 0;
  std::uint64_t mended = 0;
};

/// One object, two threads. The exchange is the finder's or the link's by turns; whoever's turn it
/// is not keeps away from it. The link gives it back when there is trouble with it.
class BoardFinder {
 public:
  using Milliseconds = std::chrono::milliseconds;
  /// How often it looks after a board that is open.
  static constexpr Milliseconds kLook{20};
  /// Between two tries to find one: the first pause doubles up to the longest. A board that cannot
  /// be opened, or dies at once, is tried less and less often.
  static constexpr Milliseconds kFirstPause{250};
  static constexpr Milliseconds kLongestPause{1000};
  static constexpr Milliseconds kLongestPauseAfterFailure{8000};  // not after a pulled cable
  /// An open board that says nothing for so long is closed and opened again.
  static constexpr Milliseconds kSilence{2000};
  /// So many stalls in a row, each within 10 s of the one before, and it is opened anew.
  static constexpr int kMaxStalls = 5;

  BoardFinder(UsbBus& bus, BoardIds wanted) : bus_(bus), wanted_(std::move(wanted)) {}

  /// The finder's thread: does what is due at `now`, on a clock that only goes forward. Returns
  /// when it wants to be called again, at the latest. May wait for the device for a moment.
  Milliseconds step(Milliseconds now);
  /// Closes the board. REQUIRES: the link is done with it.
  void close();
  /// The finder's thread.
  const BoardUsbInfo& usb_info() const noexcept { return usb_info_; }

  /// The link's thread, never waiting:
  bool send(std::span<const std::uint8_t, board::kFrameSize> frame) noexcept;
  std::size_t receive(std::span<std::uint8_t> packet) noexcept;
  bool idle() const noexcept { return turn_.load(std::memory_order_relaxed) == Turn::kFinder; }

 private:
  enum class Turn : std::uint8_t { kFinder, kLink };

  void look(Milliseconds now);
  void watch(Milliseconds now);
  void take_back(Milliseconds now);
  void lend(Milliseconds now) noexcept;
  void lose(const std::string& why, Milliseconds longest, Milliseconds now);
  /// None is open.
  void forget();
  void fail(const std::string& why, Milliseconds longest, Milliseconds now);
  void note_version(std::span<const std::uint8_t> packet) noexcept;

  UsbBus& bus_;
  BoardIds wanted_;
  BoardUsbInfo usb_info_;
  std::string name_;
  std::unique_ptr<UsbExchange> exchange_;
  Milliseconds next_{0};
  Milliseconds patience_{kFirstPause};
  Milliseconds opened_at_{0};
  Milliseconds received_at_{0};
  Milliseconds stalled_at_{0};
  int stalls_ = 0;
  std::uint32_t packets_seen_ = 0;

  std::atomic<Turn> turn_{Turn::kFinder};
  std::atomic<bool> wanted_back_{false};
  std::atomic<std::uint32_t> packets_{0};
  /// Of frames in another version of the protocol; 0: none.
  std::atomic<std::uint8_t> foreign_version_{0};
};

}  // namespace hedgehog::device
