// SPDX-License-Identifier: MIT
// Runs a simulated board on a clock of its own behind a transport, as a thread of the daemon or as
// the process hedgehog-simboard, so that its dead-man depends on nothing that the daemon does.
#pragma once

#include <atomic>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <thread>

#include "daemon/device/simulated_board.h"
#include "daemon/device/transport.h"

namespace hedgehog::device {

/// One thread: the one that calls `run`.
class SimulatedBoardRunner {
 public:
  /// `trace`, when given, gets one JSON line at the start, at every change of mode, when the
  /// current has died away after driving, when the host closes, and at the end:
  ///   {"event","board_ms","set_point_age_ms","mode","faults","awake","duty","current_a"}
  /// in the board's own milliseconds; set_point_age_ms is null before the first set-point, duty the
  /// largest of the three, current_a the true Euclidean norm.
  SimulatedBoardRunner(const SimulatedBoardOptions& options, std::unique_ptr<Transport> transport,
                       std::FILE* trace = nullptr) noexcept;

  /// Runs until the host is gone and the board is safe and without current (at most kFarewellMs
  /// later), or `stop` becomes true.
  void run(const std::atomic<bool>& stop) noexcept;

  static constexpr int kFarewellMs = 5000;
  /// Below this the windings count as without current.
  static constexpr double kZeroA = 0.1;

 private:
  void tick() noexcept;
  bool at_rest() const noexcept;
  void note(const char* event) noexcept;

  SimulatedBoard board_;
  std::unique_ptr<Transport> transport_;
  std::FILE* trace_;
  board::Mode traced_mode_ = board::Mode::kSafe;
  bool current_flowed_ = false;
};

/// The simulated board as a thread of this process.
class SimulatedBoardThread {
 public:
  /// Throws std::system_error.
  SimulatedBoardThread(const SimulatedBoardOptions& options, std::unique_ptr<Transport> transport);
  SimulatedBoardThread(const SimulatedBoardThread&) = delete;
  SimulatedBoardThread& operator=(const SimulatedBoardThread&) = delete;
  ~SimulatedBoardThread();

 private:
  SimulatedBoardRunner runner_;
  std::atomic<bool> stop_{false};
  std::thread thread_;
};

}  // namespace hedgehog::device
