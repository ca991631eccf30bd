// SPDX-License-Identifier: MIT
// hedgehog-simboard as a child process in its own group: signals to the daemon's do not reach it.
#pragma once

#include <memory>
#include <string>

#include "daemon/device/simulator/simulated_board.h"
#include "daemon/device/socket_transport.h"

namespace hedgehog::device {

struct SimulatedBoardProcessOptions {
  SimulatedBoardOptions board;
  bool in_step = false;  // a millisecond per set-point (process_lock_step.h), without a clock
  std::string program;   // empty: hedgehog-simboard in the directory of this program
  std::string trace;     // file for its trace (simulated_board_trace.h); empty: none
};

/// Owns the child. Construct and destroy it from one thread.
class SimulatedBoardProcess {
 public:
  /// Throws std::system_error when the program cannot be started.
  explicit SimulatedBoardProcess(const SimulatedBoardProcessOptions& options);
  SimulatedBoardProcess(const SimulatedBoardProcess&) = delete;
  SimulatedBoardProcess& operator=(const SimulatedBoardProcess&) = delete;
  /// REQUIRES: the transport is destroyed. Waits until the board has reached a safe state and
  /// ended; kills it after its maximum shutdown time.
  ~SimulatedBoardProcess();

  /// The host's end; can be taken once.
  std::unique_ptr<SocketTransport> take_transport() noexcept { return std::move(transport_); }
  int pid() const noexcept { return pid_; }

 private:
  std::unique_ptr<SocketTransport> transport_;
  int pid_ = -1;
};

}  // namespace hedgehog::device
