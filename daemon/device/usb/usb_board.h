// SPDX-License-Identifier: MIT
// The board on USB: the thread that searches for it, and the transport for the link thread.
#pragma once

#include <condition_variable>
#include <memory>
#include <mutex>
#include <thread>

#include "daemon/device/transport.h"
#include "daemon/device/usb/board_finder.h"

namespace hedgehog::device {

/// Made and destroyed by one thread; `usb_info` from any.
class UsbBoard {
 public:
  /// Starts the search on its own thread. Throws std::system_error.
  UsbBoard(std::unique_ptr<UsbBus> bus, const BoardIds& wanted);
  UsbBoard(const UsbBoard&) = delete;
  UsbBoard& operator=(const UsbBoard&) = delete;
  /// Sends the last frames, then closes. REQUIRES: the transport is destroyed.
  ~UsbBoard();

  /// For the link thread; receives nothing while no board is open. One at a time; the board
  /// outlives it.
  std::unique_ptr<Transport> transport();
  BoardUsbInfo usb_info() const;

 private:
  void run();

  std::unique_ptr<UsbBus> bus_;
  BoardFinder finder_;
  mutable std::mutex mutex_;
  std::condition_variable wake_;
  BoardUsbInfo usb_info_;
  bool stop_ = false;
  std::thread thread_;
};

}  // namespace hedgehog::device
