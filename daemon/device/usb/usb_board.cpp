// SPDX-License-Identifier: MIT
#include "daemon/device/usb/usb_board.h"

#include <chrono>
#include <utility>

#include "daemon/device/tick_clock.h"

namespace hedgehog::device {
namespace {

class UsbTransport : public Transport {
 public:
  explicit UsbTransport(BoardFinder& finder) : finder_(finder) {}
  bool send(std::span<const std::uint8_t, board::kFrameSize> frame) noexcept override {
    return finder_.send(frame);
  }
  std::size_t receive(std::span<std::uint8_t> packet) noexcept override {
    return finder_.receive(packet);
  }
  /// Another board may be connected at any time.
  bool open() const noexcept override { return true; }
  bool idle() const noexcept override { return finder_.idle(); }

 private:
  BoardFinder& finder_;
};

}  // namespace

UsbBoard::UsbBoard(std::unique_ptr<UsbBus> bus, const BoardIds& wanted)
    : bus_(std::move(bus)), finder_(*bus_, wanted) {
  usb_info_.what = "looking for the driver board";
  const SignalsBlocked blocked;
  thread_ = std::thread([this] { run(); });
}

UsbBoard::~UsbBoard() {
  {
    const std::lock_guard lock(mutex_);
    stop_ = true;
  }
  wake_.notify_all();
  thread_.join();
  finder_.close();
}

std::unique_ptr<Transport> UsbBoard::transport() { return std::make_unique<UsbTransport>(finder_); }

BoardUsbInfo UsbBoard::usb_info() const {
  const std::lock_guard lock(mutex_);
  return usb_info_;
}

void UsbBoard::run() {
  using Clock = std::chrono::steady_clock;
  const auto begin = Clock::now();
  std::unique_lock lock(mutex_);
  while (!stop_) {
    lock.unlock();
    const auto now = std::chrono::duration_cast<BoardFinder::Milliseconds>(Clock::now() - begin);
    const BoardFinder::Milliseconds pause = finder_.step(now);
    lock.lock();
    usb_info_ = finder_.usb_info();
    wake_.wait_for(lock, pause, [this] { return stop_; });
  }
}

}  // namespace hedgehog::device
