// SPDX-License-Identifier: MIT
// The daemon's state directory: on its own disk that can be filled, with files that may be damaged
// or replaced by FIFOs, devices and folders.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "tests/e2e/daemon_process.h"
#include "tests/soak/random.h"

namespace hedgehog::soak {

/// Gives this process its own mount namespace, so that it may mount a file system; it ends with the
/// process. False: not permitted. Call it once, before anything else.
bool may_mount();

class StateFolder {
 public:
  /// `on_small_disk`: on a disk of 512 KiB, in memory. REQUIRES then: may_mount()
  StateFolder(const e2e::Home& home, bool on_small_disk);
  StateFolder(const StateFolder&) = delete;
  StateFolder& operator=(const StateFolder&) = delete;
  ~StateFolder();

  bool is_small_disk() const noexcept { return mounted_; }
  void fill();
  void free();
  bool is_full() const noexcept { return full_; }

  /// Replaces a file by an invalid one. True: the state file itself, so that the state is or may be
  /// lost.
  bool plant(Random& random);
  /// Removes the planted files that the daemon has left in place.
  void clear();
  bool has_planted() const noexcept { return !planted_.empty(); }

  /// Incomplete files, with their modification times.
  std::map<std::string, std::string> incomplete() const;
  std::string state() const;

 private:
  std::string folder_;
  bool mounted_ = false;
  bool full_ = false;
  std::vector<std::string> planted_;
};

}  // namespace hedgehog::soak
