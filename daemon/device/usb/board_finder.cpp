// SPDX-License-Identifier: MIT
#include "daemon/device/usb/board_finder.h"

#include <algorithm>
#include <utility>

namespace hedgehog::device {
namespace {

using Milliseconds = BoardFinder::Milliseconds;

constexpr Milliseconds kCancelTimeout{500};
constexpr Milliseconds kRecoveryTimeout{100};
constexpr Milliseconds kShutdownTimeout{50};
constexpr Milliseconds kStallWindow{10'000};

}  // namespace

Milliseconds BoardFinder::step(Milliseconds now) {
  if (exchange_)
    watch(now);
  else if (now >= next_)
    scan(now);
  return exchange_ ? kCheckPeriod : std::max(next_ - now, Milliseconds(1));
}

void BoardFinder::scan(Milliseconds now) {
  const std::vector<UsbDevice> devices = bus_.list();
  const BoardChoice choice = choose_board(devices, board_ids_);
  // The back-off restarts for a newly connected board.
  if (choice.seen && !usb_info_.seen) backoff_ = kFirstPause;
  usb_info_.seen = choice.seen;
  if (!choice.index) {
    fail(choice.failure, kLongestPause, now);
    return;
  }
  const UsbDevice& device = devices[*choice.index];
  UsbPlace place = device.place;
  place.interface = choice.interface;
  std::string failure;
  auto port = bus_.open(place, failure);
  if (!port) {
    fail(describe_board(device) + ": " + failure, kLongestPauseAfterFailure, now);
    return;
  }
  exchange_ = std::make_unique<UsbExchange>(std::move(port));
  name_ = describe_board(device);
  foreign_version_.store(0, std::memory_order_relaxed);
  usb_info_.open = true;
  usb_info_.what = name_;
  usb_info_.place = device.place;
  if (!device.serial.empty()) usb_info_.serial = device.serial;
  if (std::string version = firmware_of(device); !version.empty())
    usb_info_.firmware = std::move(version);
  ++usb_info_.opened;
  opened_at_ = now;
  stalls_ = 0;
  exchange_->start();
  hand_to_link(now);
}

void BoardFinder::hand_to_link(Milliseconds now) noexcept {
  received_at_ = now;
  last_packets_ = packets_.load(std::memory_order_relaxed);
  return_requested_.store(false, std::memory_order_relaxed);
  turn_.store(Turn::kLink, std::memory_order_release);
}

void BoardFinder::watch(Milliseconds now) {
  if (turn_.load(std::memory_order_acquire) == Turn::kFinder) {
    on_returned(now);
    return;
  }
  const int version = foreign_version_.load(std::memory_order_relaxed);
  usb_info_.open = version == 0;
  usb_info_.what = version == 0 ? name_ : name_ + ": " + foreign_version(version);
  const std::uint32_t packets = packets_.load(std::memory_order_relaxed);
  if (packets != std::exchange(last_packets_, packets)) received_at_ = now;
  if (now - received_at_ >= kSilence) return_requested_.store(true, std::memory_order_relaxed);
}

void BoardFinder::on_returned(Milliseconds now) {
  switch (exchange_->fault()) {
    case UsbFault::kStalled:
      stalls_ = now - stalled_at_ < kStallWindow ? stalls_ + 1 : 1;
      stalled_at_ = now;
      if (stalls_ <= kMaxStalls && exchange_->recover(kRecoveryTimeout)) {
        ++usb_info_.recovered;
        hand_to_link(now);
      } else {
        close_failed("it stalls repeatedly", kLongestPauseAfterFailure, now);
      }
      return;
    case UsbFault::kGone:
      close_failed("it was disconnected", kLongestPause, now);
      return;
    case UsbFault::kFailed:
      close_failed("a transfer failed", kLongestPauseAfterFailure, now);
      return;
    case UsbFault::kNone:
      close_failed("it sends no frames", kLongestPauseAfterFailure, now);
  }
}

void BoardFinder::close_failed(const std::string& why, Milliseconds longest, Milliseconds now) {
  (void)exchange_->cancel_all(kCancelTimeout);
  exchange_.reset();
  ++usb_info_.closed;
  // Back-off for a board that fails right after opening.
  if (now - opened_at_ > kLongestPauseAfterFailure) backoff_ = kFirstPause;
  fail(name_ + ": " + why, longest, now);
}

void BoardFinder::clear_board() {
  usb_info_.open = false;
  usb_info_.place.reset();
  usb_info_.serial.reset();
  usb_info_.firmware.reset();
}

void BoardFinder::fail(const std::string& why, Milliseconds longest, Milliseconds now) {
  clear_board();
  usb_info_.what = why;
  backoff_ = std::min(backoff_, longest);
  next_ = now + backoff_;
  backoff_ = std::min(2 * backoff_, longest);
}

void BoardFinder::close() {
  if (!exchange_) return;
  exchange_->flush(kShutdownTimeout);
  (void)exchange_->cancel_all(kCancelTimeout);
  exchange_.reset();
  ++usb_info_.closed;
  clear_board();
  turn_.store(Turn::kFinder, std::memory_order_relaxed);
}

bool BoardFinder::send(std::span<const std::uint8_t, board::kFrameSize> frame) noexcept {
  return turn_.load(std::memory_order_acquire) == Turn::kLink && exchange_->send(frame);
}

std::size_t BoardFinder::receive(std::span<std::uint8_t> packet) noexcept {
  if (turn_.load(std::memory_order_acquire) != Turn::kLink) return 0;
  const std::size_t length = exchange_->receive(packet);
  if (length > 0) {
    packets_.store(packets_.load(std::memory_order_relaxed) + 1, std::memory_order_relaxed);
    check_version(packet.first(length));
    return length;
  }
  if (exchange_->fault() != UsbFault::kNone || return_requested_.load(std::memory_order_relaxed))
    turn_.store(Turn::kFinder, std::memory_order_release);
  return 0;
}

void BoardFinder::check_version(std::span<const std::uint8_t> packet) noexcept {
  // Only the version of an otherwise valid frame is reported.
  if (packet.size() != board::kFrameSize || packet[1] == board::kProtocolVersion) return;
  board::FrameHeader header;
  if (board::read_header(packet.data(), packet.size(), header) == board::FrameError::kVersion)
    foreign_version_.store(packet[1], std::memory_order_relaxed);
}

}  // namespace hedgehog::device
