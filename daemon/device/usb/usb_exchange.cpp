// SPDX-License-Identifier: MIT
#include "daemon/device/usb/usb_exchange.h"

#include <algorithm>

namespace hedgehog::device {
namespace {

using std::chrono::milliseconds;

constexpr milliseconds kReadPoll{10};

UsbFault fault_of(TransferEnd end) noexcept {
  switch (end) {
    case TransferEnd::kStalled:
      return UsbFault::kStalled;
    case TransferEnd::kGone:
      return UsbFault::kGone;
    case TransferEnd::kFailed:
      return UsbFault::kFailed;
    case TransferEnd::kDone:
    case TransferEnd::kCancelled:
      break;
  }
  return UsbFault::kNone;
}

}  // namespace

void UsbExchange::note(UsbFault fault) noexcept {
  if (fault_ == UsbFault::kNone) fault_ = fault;
}

void UsbExchange::start() noexcept {
  fault_ = UsbFault::kNone;
  first_ = 0;
  count_ = 0;
  for (int slot = 0; slot < kReadSlots; ++slot) submit(slot, 0);
}

void UsbExchange::submit(int slot, std::size_t length) noexcept {
  if (fault_ != UsbFault::kNone) return;
  if (!port_->submit(slot, length)) {
    note(UsbFault::kGone);
    return;
  }
  submitted_[static_cast<std::size_t>(slot)] = true;
  ++begun_;
}

bool UsbExchange::send(std::span<const std::uint8_t, board::kFrameSize> frame) noexcept {
  const auto idle = std::find(submitted_.begin() + kReadSlots, submitted_.end(), false);
  if (fault_ != UsbFault::kNone || idle == submitted_.end()) return false;
  const int slot = static_cast<int>(idle - submitted_.begin());
  std::copy(frame.begin(), frame.end(), port_->buffer(slot).begin());
  submit(slot, frame.size());
  return *idle;
}

std::size_t UsbExchange::receive(std::span<std::uint8_t> packet) noexcept {
  if (count_ == 0 && fault_ == UsbFault::kNone) (void)poll(milliseconds(0));
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
    submitted_[static_cast<std::size_t>(one.slot)] = false;
    ++ended_;
    note(fault_of(one.end));
    if (one.slot >= kReadSlots || one.end != TransferEnd::kDone) continue;
    packets_[(first_ + count_) % packets_.size()] = {one.slot, one.length};
    ++count_;
  }
  return count;
}

bool UsbExchange::none_of(int first, int last) const noexcept {
  return std::none_of(
      submitted_.begin() + first, submitted_.begin() + last, [](bool busy) { return busy; });
}

bool UsbExchange::wait_for(int first, int last, milliseconds timeout) noexcept {
  for (milliseconds left = timeout; !none_of(first, last) && left.count() > 0;)
    if (poll(kReadPoll) == 0) left -= kReadPoll;
  return none_of(first, last);
}

void UsbExchange::flush(milliseconds timeout) noexcept {
  // Packets read meanwhile are not needed, and must not fill the queue.
  for (int slot = 0; slot < kReadSlots; ++slot)
    if (submitted_[static_cast<std::size_t>(slot)]) port_->cancel(slot);
  if (fault_ == UsbFault::kNone) (void)wait_for(kReadSlots, kSlots, timeout);
}

bool UsbExchange::cancel_all(milliseconds timeout) noexcept {
  for (int slot = 0; slot < kSlots; ++slot)
    if (submitted_[static_cast<std::size_t>(slot)]) port_->cancel(slot);
  return wait_for(0, kSlots, timeout);
}

bool UsbExchange::recover(milliseconds timeout) noexcept {
  if (!cancel_all(timeout) || !port_->clear_halt()) return false;
  start();
  return fault_ == UsbFault::kNone;
}

}  // namespace hedgehog::device
