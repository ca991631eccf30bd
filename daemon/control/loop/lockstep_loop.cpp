// SPDX-License-Identifier: MIT
#include "daemon/control/loop/lockstep_loop.h"

#include <algorithm>
#include <utility>

#include "daemon/control/loop/absolute_sleep.h"
#include "daemon/control/loop/loop_meter.h"
#include "daemon/device/tick_clock.h"

namespace hedgehog::control {
namespace {

int in_range(int speed) noexcept {
  constexpr int kMinSpeed = 1;
  constexpr int kMaxSpeed = 100;
  return std::clamp(speed, kMinSpeed, kMaxSpeed);
}

}  // namespace

LockstepLoop::LockstepLoop(const ControlSettings& settings, Mailbox& mailbox,
                           device::LinkPort& port, FlightRecorder* recorder,
                           const device::SimulatedBoardOptions& board, int speed)
    : LockstepLoop(settings, mailbox, port, recorder, speed,
                   std::make_unique<device::LockStep>(port, board)) {}

LockstepLoop::LockstepLoop(const ControlSettings& settings, Mailbox& mailbox,
                           device::LinkPort& port, FlightRecorder* recorder, int speed,
                           std::unique_ptr<device::SteppedBoard> board)
    : Loop(settings, mailbox, port, recorder, in_range(speed)),
      speed_(in_range(speed)),
      board_(std::move(board)) {}

void LockstepLoop::run() noexcept {
  using device::monotonic_ns;
  model::Tick now = 0;
  std::int64_t due_ns = monotonic_ns();
  LoopMeter meter(due_ns);
  while (!stopping()) {
    due_ns += model::kNanosecondsPerTick;
    sleep_until_ns(due_ns);
    const std::int64_t woke_ns = monotonic_ns();
    meter.woke(woke_ns, woke_ns - due_ns);
    due_ns = std::max(due_ns, woke_ns - model::kNanosecondsPerTick);
    for (int i = 0; i < speed_; ++i) {
      meter.ticked(0);
      const std::int64_t begun_ns = monotonic_ns();
      tick().run(++now, 0, meter.statistics());
      meter.worked(monotonic_ns() - begun_ns);
      board_->step();
      advance(now, 1);
    }
  }
}

}  // namespace hedgehog::control
