// SPDX-License-Identifier: MIT
// Wakes io because events are unread or a client waits for a tick: a file descriptor (eventfd(2)).
#pragma once

#include <atomic>

namespace hedgehog::control {

/// Raised after events and their status are published, taken before they are read: none is missed.
class EventSignal {
 public:
  /// Throws std::system_error.
  EventSignal();
  EventSignal(const EventSignal&) = delete;
  EventSignal& operator=(const EventSignal&) = delete;
  ~EventSignal();

  /// Any thread. No allocation, no wait; one system call, none until the last signal is taken.
  void raise() noexcept;
  /// io thread.
  void take() noexcept;
  /// Readable while raised. Owned by this object.
  int descriptor() const noexcept { return descriptor_; }

 private:
  int descriptor_;
  std::atomic<bool> raised_{false};
};

}  // namespace hedgehog::control
