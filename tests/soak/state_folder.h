// SPDX-License-Identifier: MIT
// The daemon's state directory: on a disk of its own that can be filled, with files in it that are
// damaged or none.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "tests/e2e/daemon_process.h"
#include "tests/soak/random.h"

namespace hedgehog::soak {

/// Gives this process file systems of its own, so that it may mount one; it ends with the process.
/// False: not permitted. Call it once, before anything else.
bool may_mount();

class StateFolder {
 public:
  /// `on_small_disk`: of 512 KiB, in memory. REQUIRES then: may_mount()
  StateFolder(const e2e::Home& home, bool on_small_disk);
  StateFolder(const StateFolder&) = delete;
  StateFolder& operator=(const StateFolder&) = delete;
  ~StateFolder();

  bool is_small_disk() const noexcept { return mounted_; }
  void fill();
  void free();
  bool is_full() const noexcept { return full_; }

  /// Puts something odd in place of a file. True: of the state itself, so that it counts as lost,
  /// or may do so.
  bool plant(Random& random);
  /// Takes away what was planted, as far as the daemon has left it.
  void clear();
  bool has_planted() const noexcept { return !planted_.empty(); }

  /// Incomplete files, with the time of their last change.
  std::map<std::string, std::string> incomplete() const;
  std::string state() const;

 private:
  std::string folder_;
  bool mounted_ = false;
  bool full_ = false;
  std::vector<std::string> planted_;
};

}  // namespace hedgehog::soak
