// SPDX-License-Identifier: MIT
#include "daemon/device/usb/usb_exchange.h"

#include <algorithm>

namespace hedgehog::device {
namespace {

using std::chrono::milliseconds;

constexpr milliseconds kReadPoll{10};

UsbTrouble trouble_of(TransferEnd end) noexcept {
  switch (end) {
    case TransferEnd::kStalled:
      return UsbTrouble::kStalled;
    case TransferEnd::kGone:
      return UsbTrouble::kGone;
    case TransferEnd::kFailed:
      return UsbTrouble::kFailed;
    case TransferEnd::kDone:
    case TransferEnd::kCancelled:
      break;
  }
  return UsbTrouble::kNone;
}

}  // namespace

void UsbExchange::note(UsbTrouble trouble) noexcept {
  if (trouble_ == UsbTrouble::kNone) trouble_ = trouble;
}

void UsbExchange::start() noexcept {
  trouble_ = UsbTrouble::kNone;
  first_ = 0;
  count_ = 0;
  for (int slot = 0; slot < kReadSlots; ++slot) submit(slot, 0);
}

void UsbExchange::submit(int slot, std::size_t length) noexcept {
  if (trouble_ != UsbTrouble::kNone) return;
  if (!port_->submit(slot, length)) {
    note(UsbTrouble::kGone);
    return;
  }
  under_way_[static_cast<std::size_t>(slot)] = true;
  ++begun_;
}

bool UsbExchange::send(std::span<const std::uint8_t, board::kFrameSize> frame) noexcept {
  const auto idle = std::find(under_way_.begin() + kReadSlots, under_way_.end(), false);
  if (trouble_ != UsbTrouble::kNone || idle == under_way_.end()) return false;
  const int slot = static_cast<int>(idle - under_way_.begin());
  std::copy(frame.begin(), frame.end(), port_->buffer(slot).begin());
  submit(slot, frame.size());
  return *idle;
}

std::size_t UsbExchange::receive(std::span<std::uint8_t> packet) noexcept {
  if (count_ == 0 && trouble_ == UsbTrouble::kNone) (void)poll(milliseconds(0));
  while (count_ > 0) {
    const Packet next = packets_[first_];
    first_ = (first_ + 1) % packets_.size();
    --count_;
    const std::size_t length = std::min(next.length, packet.size());
    const auto bytes = port_->buffer(next.slot);
    std::copy_n(bytes.begin(), length, packet.begin());
    submit(next.slot, 0);
    if (length > 0) return length;
  }
  return 0;
}

std::size_t UsbExchange::poll(milliseconds wait) noexcept {
  std::array<Completion, kSlots> ended;
  const std::size_t count = port_->poll(ended, wait);
  for (const Completion& one : std::span(ended).first(count)) {
    under_way_[static_cast<std::size_t>(one.slot)] = false;
    ++ended_;
    note(trouble_of(one.end));
    if (one.slot >= kReadSlots || one.end != TransferEnd::kDone) continue;
    packets_[(first_ + count_) % packets_.size()] = {one.slot, one.length};
    ++count_;
  }
  return count;
}

bool UsbExchange::none_of(int first, int last) const noexcept {
  return std::none_of(
      under_way_.begin() + first, under_way_.begin() + last, [](bool busy) { return busy; });
}

bool UsbExchange::wait_for(int first, int last, milliseconds patience) noexcept {
  for (milliseconds left = patience; !none_of(first, last) && left.count() > 0;)
    if (poll(kReadPoll) == 0) left -= kReadPoll;
  return none_of(first, last);
}

void UsbExchange::flush(milliseconds patience) noexcept {
  // Packets read meanwhile are not needed, and must not fill the queue.
  for (int slot = 0; slot < kReadSlots; ++slot)
    if (under_way_[static_cast<std::size_t>(slot)]) port_->cancel(slot);
  if (trouble_ == UsbTrouble::kNone) (void)wait_for(kReadSlots, kSlots, patience);
}

bool UsbExchange::cancel_all(milliseconds patience) noexcept {
  for (int slot = 0; slot < kSlots; ++slot)
    if (under_way_[static_cast<std::size_t>(slot)]) port_->cancel(slot);
  return wait_for(0, kSlots, patience);
}

bool UsbExchange::recover(milliseconds patience) noexcept {
  if (!cancel_all(patience) || !port_->clear_halt()) return false;
  start();
  return trouble_ == UsbTrouble::kNone;
}

}  // namespace hedgehog::device
