// SPDX-License-Identifier: MIT
// Lock-step of the link and a simulated board in another process: `hedgehogd --simulate --speed N`
// with simulator.process. The link's steps define the board's time.
#pragma once

#include <memory>
#include <utility>

#include "daemon/device/link.h"
#include "daemon/device/link_port.h"
#include "daemon/device/simulator/lock_step.h"
#include "daemon/device/socket_transport.h"

namespace hedgehog::device {

/// One thread. A step sends the frames of the link and processes those of the board until its truth
/// frame, which ends each millisecond. A board that once did not respond in time has hung: its
/// socket is closed, and the following steps do not wait.
class ProcessLockStep final : public SteppedBoard {
 public:
  static constexpr int kMaxWaitMs = 20'000;  // the first response includes the start of the process

  /// `port` must outlive it.
  ProcessLockStep(LinkPort& port, std::unique_ptr<SocketTransport> socket,
                  int max_wait_ms = kMaxWaitMs) noexcept
      : port_(port), socket_(std::move(socket)), max_wait_ms_(max_wait_ms) {}

  void step() noexcept override;

 private:
  void exchange(const LinkFrames& frames) noexcept;
  bool receive_until_truth() noexcept;  // false: the board did not respond in time

  LinkPort& port_;
  std::unique_ptr<SocketTransport> socket_;  // null: the board has hung
  int max_wait_ms_;
  Link link_;
};

}  // namespace hedgehog::device
