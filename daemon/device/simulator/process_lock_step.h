// SPDX-License-Identifier: MIT
// Link and a simulated board in another process, in lock-step: `hedgehogd --simulate --speed N`
// with simulator.process. The link's steps define the board's time, independent of the execution
// times.
#pragma once

#include <memory>
#include <utility>

#include "daemon/device/link.h"
#include "daemon/device/link_port.h"
#include "daemon/device/simulator/lock_step.h"
#include "daemon/device/socket_transport.h"

namespace hedgehog::device {

/// One thread. A step sends the frames of the link, then waits for the board's truth frame, which
/// ends each millisecond of a lock-step board, and processes the frames before it. A board that
/// once did not respond in time has hung: its socket is closed, and the following steps do not
/// wait.
class ProcessLockStep final : public SteppedBoard {
 public:
  /// Timeout of a response; the first one includes the start of the board's process.
  static constexpr int kMaxWaitMs = 20'000;

  /// `port` must outlive it.
  ProcessLockStep(LinkPort& port, std::unique_ptr<SocketTransport> socket,
                  int max_wait_ms = kMaxWaitMs) noexcept
      : port_(port), socket_(std::move(socket)), max_wait_ms_(max_wait_ms) {}

  void step() noexcept override;

 private:
  void exchange(const LinkFrames& frames) noexcept;
  /// False: the board did not respond in time.
  bool receive_until_truth() noexcept;

  LinkPort& port_;
  std::unique_ptr<SocketTransport> socket_;  // null: the board has hung
  int max_wait_ms_;
  Link link_;
};

}  // namespace hedgehog::device
