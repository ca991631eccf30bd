// SPDX-License-Identifier: MIT
// The signal to io to look at the ball, because events are unread or a client waits for a tick: a
// file descriptor that io's poll waits for (eventfd(2)).
#pragma once

#include <atomic>

namespace hedgehog::control {

/// Raised after the events, and the status that belongs to them, have been published; taken before
/// they are read. So none is left unread without a signal.
class EventSignal {
 public:
  /// Throws std::system_error.
  EventSignal();
  EventSignal(const EventSignal&) = delete;
  EventSignal& operator=(const EventSignal&) = delete;
  ~EventSignal();

  /// Any thread. Neither allocates nor waits. One system call, none while the last signal has
  /// not been taken: while io hangs, `raise` makes no further call.
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
