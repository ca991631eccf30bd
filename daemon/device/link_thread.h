// SPDX-License-Identifier: MIT
// Thread that owns the transport: once a millisecond it sends control's set-point and receives the
// board's telemetry. Without a board it retries every 10 ms.
#pragma once

#include <atomic>
#include <memory>
#include <optional>
#include <thread>

#include "daemon/device/link.h"
#include "daemon/device/link_port.h"
#include "daemon/device/transport.h"

namespace hedgehog::device {

/// The thread "link" (SCHED_FIFO just below control when allowed). Construct and destroy it from
/// one thread; it communicates only by the port.
class LinkThread {
 public:
  /// Starts at once. `port` must outlive it. Throws std::system_error.
  LinkThread(LinkPort& port, std::unique_ptr<Transport> transport,
             const std::optional<BoardLimits>& limits = std::nullopt);
  LinkThread(const LinkThread&) = delete;
  LinkThread& operator=(const LinkThread&) = delete;
  ~LinkThread();  // sends the safe command once more, then ends

 private:
  void run() noexcept;
  void tick() noexcept;

  LinkPort& port_;
  std::unique_ptr<Transport> transport_;
  Link link_;
  std::atomic<bool> stop_{false};
  std::thread thread_;
};

}  // namespace hedgehog::device
