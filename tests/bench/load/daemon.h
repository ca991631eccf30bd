// SPDX-License-Identifier: MIT
// A daemon on the simulator, started for one measurement.
#pragma once

#include <optional>
#include <string>

#include "tests/bench/load/child.h"
#include "tests/bench/load/delays.h"
#include "tests/temporary_folder.h"

namespace hedgehog::bench {

/// On a free port, with its own state folder and a limit of 1024 clients.
class Daemon {
 public:
  explicit Daemon(const std::string& program);

  int port() const noexcept { return port_; }
  const Child& process() const noexcept { return *process_; }
  Child& process() noexcept { return *process_; }
  struct Quantiles {
    double p50_us = 0.0;
    double p99_us = 0.0;
  };
  /// Lateness of the control loop's ticks since the start, as of its last aggregation, at most a
  /// second ago.
  Quantiles lateness() const;
  /// From reading a request to the board: the newest effects, by `effect.latency`; for a daemon
  /// without this method, by its histogram. `effect.latency` has none while no effect has
  /// reached the board.
  std::optional<Quantiles> request_to_board() const;
  /// A histogram of /metrics since the start, without the prefix of its name.
  DelayHistogram histogram(const std::string& name) const;

 private:
  TemporaryFolder home_;
  std::optional<Child> process_;
  int port_ = 0;
  int http_port_ = 0;
};

}  // namespace hedgehog::bench
