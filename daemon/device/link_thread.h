// SPDX-License-Identifier: MIT
// The thread that owns the transport: once a millisecond, what control said goes to the board, and
// what the board said goes to control.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>
#include <thread>

#include "daemon/device/link.h"
#include "daemon/device/link_port.h"
#include "daemon/device/transport.h"

namespace hedgehog::device {

/// The thread "link" (SCHED_FIFO just below control when allowed). Construct and destroy it from
/// one thread; the port is its only other contact.
class LinkThread {
 public:
  /// Starts at once. `port` must outlive it. Throws std::system_error.
  LinkThread(LinkPort& port, std::unique_ptr<Transport> transport,
             const std::optional<BoardLimits>& limits = std::nullopt);
  LinkThread(const LinkThread&) = delete;
  LinkThread& operator=(const LinkThread&) = delete;
  /// Sends the safe command a last time, then ends.
  ~LinkThread();

  /// Any thread: milliseconds that were left out because the thread was late.
  std::uint64_t skipped() const noexcept { return skipped_.load(std::memory_order_relaxed); }
  /// Any thread: the system allowed SCHED_FIFO.
  bool real_time() const noexcept { return real_time_.load(std::memory_order_relaxed); }

 private:
  void run() noexcept;
  void tick() noexcept;

  LinkPort& port_;
  std::unique_ptr<Transport> transport_;
  Link link_;
  bool simulator_known_ = false;
  std::atomic<bool> stop_{false};
  std::atomic<bool> real_time_{false};
  std::atomic<std::uint64_t> skipped_{0};
  std::thread thread_;
};

}  // namespace hedgehog::device
