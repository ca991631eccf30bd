// SPDX-License-Identifier: MIT
// Reference loop: sleeps until the next millisecond, 1000 times per second, and does nothing else.
// Memory locked and scheduling as in the control thread, where the system allows it. At the end of
// its input it prints what cyclictest --histogram prints: microseconds of lateness and their
// counts.
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdint>
#include <iostream>
#include <thread>

#include "daemon/control/loop/absolute_sleep.h"
#include "daemon/device/tick_clock.h"

namespace {

namespace device = hedgehog::device;

constexpr std::int64_t kPeriodNs = 1'000'000;
std::array<std::uint64_t, 20'000> late_us{};

void loop(const std::atomic<bool>& stopping) {
  device::use_fifo(device::kControlPriority);
  for (std::int64_t due = device::monotonic_ns() + kPeriodNs; !stopping;) {
    hedgehog::control::sleep_until_ns(due);
    const std::int64_t now = device::monotonic_ns();
    const auto late = static_cast<std::size_t>(std::max<std::int64_t>(0, now - due) / 1000);
    ++late_us[std::min(late, late_us.size() - 1)];
    due += kPeriodNs * ((now - due) / kPeriodNs + 1);
  }
}

}  // namespace

int main() {
  std::atomic<bool> stopping{false};
  std::thread thread(loop, std::cref(stopping));
  // All memory of the loop; if the lock limit is too small, it is measured without the lock.
  static_cast<void>(mlockall(MCL_CURRENT));
  std::cout << "loops" << std::endl;
  char byte = 0;
  while (::read(STDIN_FILENO, &byte, 1) > 0) {
  }
  stopping = true;
  thread.join();
  for (std::size_t us = 0; us < late_us.size(); ++us)
    if (late_us[us] != 0) std::cout << us << ' ' << late_us[us] << '\n';
}
