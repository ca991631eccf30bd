// SPDX-License-Identifier: MIT
#include "daemon/control/lockstep_loop.h"

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
  LoopMeter meter(due_ns);
  while (!stopping_.load(std::memory_order_acquire)) {
    due_ns += kNanosecondsPerTick;
    sleep_until_ns(due_ns);
    const std::int64_t woke_ns = monotonic_ns();
    meter.woke(woke_ns, woke_ns - due_ns);
    due_ns = std::max(due_ns, woke_ns - kNanosecondsPerTick);
    for (int i = 0; i < speed_; ++i) {
      meter.ticked(0);
      const std::int64_t begun_ns = monotonic_ns();
      tick_.run(++tick, 0, meter.statistics());
      meter.worked(monotonic_ns() - begun_ns);
      world_.step();
      now_.store(tick, std::memory_order_relaxed);
    }
    heartbeat_.fetch_add(static_cast<std::uint64_t>(speed_), std::memory_order_relaxed);
  }
  tick_.shut_down();
  for (int i = 0; i < ControlTick::kMaxSafeTicks && !confirmed_; ++i) {
    confirmed_ = tick_.run_safe();
    world_.step();
  }
}

}  // namespace hedgehog::control
