// SPDX-License-Identifier: MIT
// Statistics of a soak, as text.
#pragma once

#include <cstdint>
#include <map>
#include <string>

namespace hedgehog::soak {

struct Summary {
  std::uint64_t rounds = 0;
  std::uint64_t starts = 0;
  std::uint64_t kills = 0;
  std::uint64_t stops = 0;  // by SIGTERM or SIGINT
  std::uint64_t reloads = 0;
  std::uint64_t connections = 0;
  std::uint64_t requests = 0;  // items of lines, batches and frames of any kind
  std::uint64_t notifications = 0;
  std::uint64_t checks = 0;   // full checks with nothing pending
  std::uint64_t latches = 0;  // emergency stops that persisted over a kill
  std::uint64_t full_disks = 0;
  std::uint64_t unusual_files = 0;              // planted in the state directory
  std::map<int, std::uint64_t> responses;       // by error code; 0: results
  std::map<std::string, std::uint64_t> closed;  // by the daemon, by reason

  /// One line of progress.
  std::string line() const;
  /// The full report.
  std::string text() const;
};

}  // namespace hedgehog::soak
