// SPDX-License-Identifier: MIT
#include "daemon/control/control_loop.h"

#include <pthread.h>

#include <algorithm>

#include "daemon/control/absolute_sleep.h"
#include "daemon/control/loop_meter.h"
#include "daemon/device/tick_clock.h"

namespace hedgehog::control {
namespace {

using device::monotonic_ns;
using model::kNanosecondsPerTick;
using model::Tick;

}  // namespace

ControlLoop::ControlLoop(const ControlSettings& settings, Mailbox& mailbox, device::LinkPort& port,
                         FlightRecorder* recorder)
    : tick_(settings, mailbox, port, recorder), origin_ns_(monotonic_ns()) {}

ControlLoop::~ControlLoop() { stop(); }

void ControlLoop::start() {
  const device::SignalsBlocked blocked;
  thread_ = std::thread([this] {
    pthread_setname_np(pthread_self(), "control");
    realtime_ = device::use_fifo(device::kControlPriority);
    started_.store(true, std::memory_order_release);
    started_.notify_one();
    run();
  });
  started_.wait(false, std::memory_order_acquire);
}

bool ControlLoop::stop() noexcept {
  stopping_.store(true, std::memory_order_release);
  if (thread_.joinable()) thread_.join();
  return confirmed_;
}

void ControlLoop::run() noexcept {
  Tick tick = (monotonic_ns() - origin_ns_) / kNanosecondsPerTick;
  LoopMeter meter(monotonic_ns());
  while (!stopping_.load(std::memory_order_acquire)) {
    const Tick due = tick + 1;
    sleep_until_ns(origin_ns_ + due * kNanosecondsPerTick);
    const std::int64_t woke_ns = monotonic_ns();
    // The grid decides which tick this is: those that were slept through are gone.
    tick = (woke_ns - origin_ns_) / kNanosecondsPerTick;
    if (tick < due) tick = due;
    const auto skipped = static_cast<std::uint32_t>(tick - due);
    meter.ticked(skipped);
    meter.woke(woke_ns, woke_ns - origin_ns_ - due * kNanosecondsPerTick);
    tick_.run(tick, skipped, meter.statistics());
    meter.worked(monotonic_ns() - woke_ns);
    now_.store(tick, std::memory_order_relaxed);
    heartbeat_.fetch_add(1, std::memory_order_relaxed);
  }
  leave();
}

void ControlLoop::leave() noexcept {
  tick_.shut_down();
  std::int64_t next_ns = monotonic_ns();
  for (int i = 0; i < ControlTick::kMaxSafeTicks && !confirmed_; ++i) {
    confirmed_ = tick_.run_safe();
    // Never a burst: the board has to be heard in between.
    next_ns = std::max(next_ns, monotonic_ns()) + kNanosecondsPerTick;
    sleep_until_ns(next_ns);
  }
}

}  // namespace hedgehog::control
