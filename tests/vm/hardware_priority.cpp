// SPDX-License-Identifier: MIT
#include "tests/vm/hardware_priority.h"

#include <gtest/gtest.h>
#include <sched.h>

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <string>

namespace hedgehog::vm {
namespace {

namespace fs = std::filesystem;

/// Above those of the daemon's threads.
constexpr int kHardwarePriority = 90;

void run_first(pid_t thread) {
  sched_param parameters{};
  parameters.sched_priority = kHardwarePriority;
  // It may have ended: a device was unplugged.
  const bool set = ::sched_setscheduler(thread, SCHED_FIFO, &parameters) == 0;
  EXPECT_TRUE(set || errno == ESRCH) << errno;
}

}  // namespace

void run_hardware_first(pid_t emulator) {
  run_first(emulator);
  for (const fs::directory_entry& entry : fs::directory_iterator("/proc")) {
    std::string name;
    std::getline(std::ifstream(entry.path() / "comm") >> std::ws, name);
    if (name == "vhci_rx" || name == "vhci_tx") run_first(std::stoi(entry.path().filename()));
  }
}

}  // namespace hedgehog::vm
