// SPDX-License-Identifier: MIT
// A USB in memory: boards that a test plugs in, unplugs and stalls. It counts what was opened,
// closed, and left in transfer.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "daemon/device/usb/usb_handle.h"
#include "daemon/device/usb/usb_port.h"

namespace hedgehog::device {

/// The device: outlives its ports, as a real one does.
struct FakeBoard {
  UsbDevice device;
  /// The libusb error on opening; 0: none.
  int open_error = 0;
  bool plugged = true;
  bool stalled = false;
  bool clear_halt_works = true;
  /// False: frames to it are never completed.
  bool listens = true;
  bool transfers_fail = false;
  /// Packets that it sends next, and those that it has received.
  std::deque<std::vector<std::uint8_t>> packets;
  std::vector<std::vector<std::uint8_t>> on_event;

  int open_ports = 0;
  int opened = 0;
  int halts_cleared = 0;
  std::uint64_t begun = 0;
  std::uint64_t ended = 0;
  /// Transfers that were not completed when their port was closed.
  int still_submitted = 0;
};

class FakeUsbPort : public UsbPort {
 public:
  explicit FakeUsbPort(FakeBoard& board) : board_(board) {
    ++board_.open_ports;
    ++board_.opened;
  }
  ~FakeUsbPort() override {
    --board_.open_ports;
    board_.still_submitted += static_cast<int>(submitted_.size());
  }

  std::span<std::uint8_t, kSlotBytes> buffer(int slot) noexcept override {
    return bytes_[static_cast<std::size_t>(slot)];
  }
  bool submit(int slot, std::size_t length) noexcept override {
    if (!board_.plugged) return false;
    submitted_.push_back({slot, TransferEnd::kDone, length});
    ++board_.begun;
    return true;
  }
  void cancel(int slot) noexcept override { cancelled_.push_back(slot); }

  std::size_t poll(std::span<Completion> ended, std::chrono::milliseconds) noexcept override {
    std::size_t count = 0;
    for (std::size_t i = 0; i < submitted_.size() && count < ended.size();) {
      Completion one = submitted_[i];
      if (!ends(one)) {
        ++i;
        continue;
      }
      submitted_.erase(submitted_.begin() + static_cast<std::ptrdiff_t>(i));
      std::erase(cancelled_, one.slot);
      ended[count++] = one;
    }
    board_.ended += count;
    return count;
  }
  bool clear_halt() noexcept override {
    ++board_.halts_cleared;
    if (board_.clear_halt_works) board_.stalled = false;
    return board_.clear_halt_works && board_.plugged;
  }

 private:
  bool ends(Completion& one) {
    const auto end = [&](TransferEnd how) {
      one.end = how;
      one.length = 0;
      return true;
    };
    if (!board_.plugged) return end(TransferEnd::kGone);
    if (std::find(cancelled_.begin(), cancelled_.end(), one.slot) != cancelled_.end())
      return end(TransferEnd::kCancelled);
    if (board_.stalled) return end(TransferEnd::kStalled);
    if (board_.transfers_fail) return end(TransferEnd::kFailed);
    auto& bytes = bytes_[static_cast<std::size_t>(one.slot)];
    if (one.slot >= kReadSlots) {
      if (!board_.listens) return false;
      board_.on_event.emplace_back(bytes.begin(), bytes.begin() + static_cast<long>(one.length));
      return true;
    }
    if (board_.packets.empty()) return false;
    const std::vector<std::uint8_t> packet = board_.packets.front();
    board_.packets.pop_front();
    std::copy(packet.begin(), packet.end(), bytes.begin());
    one.length = packet.size();
    return true;
  }

  FakeBoard& board_;
  std::array<std::array<std::uint8_t, kSlotBytes>, kSlots> bytes_{};
  std::deque<Completion> submitted_;
  std::vector<int> cancelled_;
};

struct FakeUsb : UsbBus {
  std::vector<std::unique_ptr<FakeBoard>> boards;
  int listed = 0;

  FakeBoard& plug_in(const std::string& serial, int protocol = 1) {
    auto made = std::make_unique<FakeBoard>();
    made->device.place = {1, static_cast<int>(boards.size()) + 2, -1};
    made->device.vendor = 0x1209;
    made->device.product = 0x0001;
    made->device.manufacturer = "Hedgehog";
    made->device.name = "Hedgehog driver board";
    made->device.serial = serial;
    made->device.release = "0102";
    made->device.interfaces = {{0, 0x08, 0x06, 0x50},
                               {1, 0xFF, 0x48, static_cast<std::uint8_t>(protocol)}};
    boards.push_back(std::move(made));
    return *boards.back();
  }

  std::vector<UsbDevice> list() override {
    ++listed;
    std::vector<UsbDevice> devices;
    for (const auto& board : boards)
      if (board->plugged) devices.push_back(board->device);
    return devices;
  }
  std::unique_ptr<UsbPort> open(const UsbPlace& place, std::string& failure) override {
    for (const auto& board : boards) {
      if (board->device.place.address != place.address || !board->plugged) continue;
      claimed_interface = place.interface;
      if (board->open_error == 0) return std::make_unique<FakeUsbPort>(*board);
      failure = usb_failure(board->open_error);
      return nullptr;
    }
    failure = usb_failure(LIBUSB_ERROR_NO_DEVICE);
    return nullptr;
  }

  int claimed_interface = -1;
};

}  // namespace hedgehog::device
