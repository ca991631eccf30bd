// SPDX-License-Identifier: MIT
#include "daemon/control/lockstep_loop.h"

#include <pthread.h>

#include <algorithm>

#include "daemon/control/absolute_sleep.h"
#include "daemon/device/tick_clock.h"

namespace hedgehog::control {
namespace {

using device::monotonic_ns;
using model::kNanosecondsPerTick;
using model::Tick;

constexpr int kSafePatienceTicks = 100;
constexpr int kSlowest = 1;
constexpr int kFastest = 100;

}  // namespace

LockstepLoop::LockstepLoop(const ControlSettings& settings, Mailbox& mailbox,
                           device::LinkPort& port, FlightRecorder* recorder,
                           const device::SimulatedBoardOptions& board, int speed)
    : speed_(std::clamp(speed, kSlowest, kFastest)),
      tick_(settings, mailbox, port, recorder, speed_),
      world_(port, board),
      origin_ns_(monotonic_ns()) {}

LockstepLoop::~LockstepLoop() { stop(); }

void LockstepLoop::start() {
  const device::SignalsBlocked blocked;
  thread_ = std::thread([this] {
    pthread_setname_np(pthread_self(), "control");
    run();
  });
}

bool LockstepLoop::stop() noexcept {
  stopping_.store(true, std::memory_order_release);
  if (thread_.joinable()) thread_.join();
  return confirmed_;
}

void LockstepLoop::run() noexcept {
  Tick tick = 0;
  std::int64_t due_ns = monotonic_ns();
  std::int64_t summed_ns = due_ns;
  std::uint64_t summed_ticks = 0;
  while (!stopping_.load(std::memory_order_acquire)) {
    due_ns += kNanosecondsPerTick;
    sleep_until_ns(due_ns);
    const std::int64_t woke_ns = monotonic_ns();
    lateness_.add(woke_ns - due_ns);
    due_ns = std::max(due_ns, woke_ns - kNanosecondsPerTick);
    if (woke_ns - summed_ns >= model::kTicksPerSecond * kNanosecondsPerTick) {
      const Lateness::Summary summary = lateness_.summary();
      statistics_.lateness_p50_us = summary.p50_us;
      statistics_.lateness_p99_us = summary.p99_us;
      statistics_.lateness_max_us = summary.max_us;
      statistics_.rate_hz = static_cast<double>(statistics_.ticks - summed_ticks) * 1e9 /
                            static_cast<double>(woke_ns - summed_ns);
      summed_ns = woke_ns;
      summed_ticks = statistics_.ticks;
    }
    for (int i = 0; i < speed_; ++i) {
      ++statistics_.ticks;
      tick_.run(++tick, 0, statistics_);
      world_.step();
      now_.store(tick, std::memory_order_relaxed);
    }
    heartbeat_.fetch_add(static_cast<std::uint64_t>(speed_), std::memory_order_relaxed);
  }
  tick_.shut_down();
  for (int i = 0; i < kSafePatienceTicks && !confirmed_; ++i) {
    confirmed_ = tick_.run_safe();
    world_.step();
  }
}

}  // namespace hedgehog::control
