// SPDX-License-Identifier: MIT
// One round of a soak: a few starts of the daemon on one state directory, each with its clients and
// a random kind of end. It depends on its seed only.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "tests/e2e/daemon_process.h"
#include "tests/soak/actions.h"
#include "tests/soak/state_folder.h"
#include "tests/soak/summary.h"
#include "tests/soak/traffic.h"

namespace hedgehog::soak {

struct RoundSize {
  int starts = 4;
  int actions = 400;  // per start
};

class Round {
 public:
  Round(std::uint64_t seed, RoundSize size, Summary& summary);
  /// Throws Failure, which contains the end of the daemon's log.
  void run();

 private:
  enum class End { kTerminate, kInterrupt, kTerminateBusy, kKill, kKillLatched, kKillFull };
  /// State that a start inherits from the previous end.
  struct Inherited {
    bool latched = false;  // an emergency stop is persisted
    bool orderly = false;  // the persisted state must be as the daemon wrote it
    std::map<std::string, std::string> incomplete;
  };

  void run_start(int number);
  void check_start(Traffic& traffic);
  void act(Traffic& traffic, Actions& actions, int count);
  void use_full_disk(Traffic& traffic, Actions& actions);
  void end(Traffic& traffic, Actions& actions, End how);
  void stop_and_kill(Traffic& traffic, Actions& actions);
  void terminate(Traffic& traffic, int signal, bool is_quiet);
  void kill(Traffic& traffic);

  std::uint64_t seed_;
  RoundSize size_;
  Summary& summary_;
  Random random_;  // for the round
  Random draws_;   // for the actions
  RequestGenerator generator_;
  e2e::Home home_;
  StateFolder folder_;
  std::unique_ptr<e2e::DaemonProcess> daemon_;
  Inherited inherited_;
  bool disk_was_full_ = false;  // during this start
};

}  // namespace hedgehog::soak
