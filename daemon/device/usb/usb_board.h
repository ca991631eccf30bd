// SPDX-License-Identifier: MIT
// The board on USB: the thread that looks for it, and the transport that the link thread gets.
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
  /// Looks for it from now on, on a thread of its own. Throws std::system_error.
  UsbBoard(std::unique_ptr<UsbBus> bus, const BoardIds& wanted);
  UsbBoard(const UsbBoard&) = delete;
  UsbBoard& operator=(const UsbBoard&) = delete;
  /// Lets the last frames go out, then closes. REQUIRES: the transport is gone.
  ~UsbBoard();

  /// For the link thread, which hears nothing while there is no board. One at a time; the board
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
