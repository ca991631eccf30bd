// SPDX-License-Identifier: MIT
// A simulated board on its own clock, as the process hedgehog-simboard: its dead-man is independent
// of the daemon.
#pragma once

#include <atomic>
#include <cstdint>
#include <cstdio>
#include <memory>

#include "daemon/device/simulator/simulated_board.h"
#include "daemon/device/simulator/simulated_board_trace.h"
#include "daemon/device/socket_transport.h"
#include "daemon/device/transport.h"

namespace hedgehog::device {

/// One thread: the one that calls `run`.
class SimulatedBoardRunner {
 public:
  /// `trace`, if not null: the lines of simulated_board_trace.h, and "closed" at the host's end.
  SimulatedBoardRunner(const SimulatedBoardOptions& options, std::unique_ptr<Transport> transport,
                       std::FILE* trace = nullptr) noexcept;

  /// Until `stop`, or until the host has disconnected and the board is safe and without current.
  void run(const std::atomic<bool>& stop) noexcept;

  /// Runs a millisecond for each set-point of a lock-step host (process_lock_step.h) until it
  /// disconnects; call `run` afterwards. `socket` is the runner's transport.
  void run_in_step(const SocketTransport& socket) noexcept;

  static constexpr int kShutdownMs = 5000;  // at most, after the host has disconnected

 private:
  void tick() noexcept;
  bool at_rest() const noexcept;

  SimulatedBoard board_;
  std::unique_ptr<Transport> transport_;
  SimulatedBoardTrace trace_;
};

}  // namespace hedgehog::device
