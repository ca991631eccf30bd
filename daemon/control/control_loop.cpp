// SPDX-License-Identifier: MIT
#include "daemon/control/control_loop.h"

#include <pthread.h>

#include "daemon/control/absolute_sleep.h"
#include "daemon/device/tick_clock.h"

namespace hedgehog::control {
namespace {

using device::monotonic_ns;
using model::kNanosecondsPerTick;
using model::Tick;

constexpr Tick kStatisticsEvery = model::kTicksPerSecond;
constexpr int kSafePatienceTicks = 100;

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
  Tick summed_at = tick;
  std::int64_t summed_ns = monotonic_ns();
  std::uint64_t summed_ticks = 0;
  while (!stopping_.load(std::memory_order_acquire)) {
    const Tick due = tick + 1;
    sleep_until_ns(origin_ns_ + due * kNanosecondsPerTick);
    const std::int64_t woke_ns = monotonic_ns();
    // The grid decides which tick this is: those that were slept through are gone.
    tick = (woke_ns - origin_ns_) / kNanosecondsPerTick;
    if (tick < due) tick = due;
    const auto skipped = static_cast<std::uint32_t>(tick - due);
    lateness_.add(woke_ns - origin_ns_ - due * kNanosecondsPerTick);
    ++statistics_.ticks;
    statistics_.skipped += skipped;
    if (tick - summed_at >= kStatisticsEvery) {
      const Lateness::Summary summary = lateness_.summary();
      statistics_.lateness_p50_us = summary.p50_us;
      statistics_.lateness_p99_us = summary.p99_us;
      statistics_.lateness_max_us = summary.max_us;
      statistics_.rate_hz = static_cast<double>(statistics_.ticks - summed_ticks) * 1e9 /
                            static_cast<double>(woke_ns - summed_ns);
      summed_at = tick;
      summed_ns = woke_ns;
      summed_ticks = statistics_.ticks;
    }
    tick_.run(tick, skipped, statistics_);
    now_.store(tick, std::memory_order_relaxed);
    heartbeat_.fetch_add(1, std::memory_order_relaxed);
  }
  leave();
}

void ControlLoop::leave() noexcept {
  tick_.shut_down();
  std::int64_t next_ns = monotonic_ns();
  for (int i = 0; i < kSafePatienceTicks && !confirmed_; ++i) {
    confirmed_ = tick_.run_safe();
    next_ns += kNanosecondsPerTick;
    sleep_until_ns(next_ns);
  }
}

}  // namespace hedgehog::control
