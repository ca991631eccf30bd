// SPDX-License-Identifier: MIT
// Link and a simulated board in another process, in lock-step: `hedgehogd --simulate --speed N`
// with simulator.process. The board's time is the link's, whatever either of them takes for it.
#pragma once

#include <memory>
#include <utility>

#include "daemon/device/link.h"
#include "daemon/device/link_port.h"
#include "daemon/device/simulator/lock_step.h"
#include "daemon/device/socket_transport.h"

namespace hedgehog::device {

/// One thread. A step sends the frames of the link, then waits for the board's frame of truth,
/// which ends each millisecond of a board in step, and takes what came before it. A board that once
/// did not answer in time is hung: its socket is closed, and the steps that follow wait for
/// nothing.
class ProcessLockStep final : public SteppedBoard {
 public:
  /// Longest wait for an answer; the first one includes the start of the board's process.
  static constexpr int kMaxWaitMs = 20'000;

  /// `port` must outlive it.
  ProcessLockStep(LinkPort& port, std::unique_ptr<SocketTransport> socket,
                  int max_wait_ms = kMaxWaitMs) noexcept
      : port_(port), socket_(std::move(socket)), max_wait_ms_(max_wait_ms) {}

  void step() noexcept override;

 private:
  void exchange(const LinkFrames& frames) noexcept;
  /// False: the board did not answer in time.
  bool receive_until_truth() noexcept;

  LinkPort& port_;
  std::unique_ptr<SocketTransport> socket_;  // null: the board has hung
  int max_wait_ms_;
  Link link_;
};

}  // namespace hedgehog::device
