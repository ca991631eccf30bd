// SPDX-License-Identifier: MIT
// What a soak has done, for a person.
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
  std::uint64_t requests = 0;  // items of lines, batches and frames; whatever they were
  std::uint64_t notifications = 0;
  std::uint64_t checks = 0;   // of everything, with nothing pending
  std::uint64_t latches = 0;  // emergency stops that outlived a kill
  std::uint64_t full_disks = 0;
  std::uint64_t odd_files = 0;                  // planted in the state directory
  std::map<int, std::uint64_t> answers;         // by error code; 0: results
  std::map<std::string, std::uint64_t> closed;  // by the daemon, and why

  /// One line of progress.
  std::string line() const;
  /// All of it.
  std::string text() const;
};

}  // namespace hedgehog::soak
