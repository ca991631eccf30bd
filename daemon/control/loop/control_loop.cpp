// SPDX-License-Identifier: MIT
#include "daemon/control/loop/control_loop.h"

#include <algorithm>

#include "daemon/control/loop/absolute_sleep.h"
#include "daemon/control/loop/loop_meter.h"
#include "daemon/device/tick_clock.h"

namespace hedgehog::control {

using device::monotonic_ns;
using model::kNanosecondsPerTick;
using model::Tick;

bool ControlLoop::schedule() noexcept { return device::use_fifo(device::kControlPriority); }

void ControlLoop::run() noexcept {
  Tick now = (monotonic_ns() - origin_ns()) / kNanosecondsPerTick;
  LoopMeter meter(monotonic_ns());
  while (!stopping()) {
    const Tick due = now + 1;
    sleep_until_ns(origin_ns() + due * kNanosecondsPerTick);
    const std::int64_t woke_ns = monotonic_ns();
    // The time grid determines the number of this tick: those missed are skipped.
    now = std::max(due, (woke_ns - origin_ns()) / kNanosecondsPerTick);
    const auto skipped = static_cast<std::uint32_t>(now - due);
    meter.ticked(skipped);
    meter.woke(woke_ns, woke_ns - origin_ns() - due * kNanosecondsPerTick);
    tick().run(now, skipped, meter.statistics());
    meter.worked(monotonic_ns() - woke_ns);
    advance(now, 1);
  }
  next_ns_ = monotonic_ns();
}

// Never in a burst: the board has to respond in between.
void ControlLoop::after_safe_tick() noexcept {
  next_ns_ = std::max(next_ns_, monotonic_ns()) + kNanosecondsPerTick;
  sleep_until_ns(next_ns_);
}

}  // namespace hedgehog::control
