// SPDX-License-Identifier: MIT
#include "daemon/control/loop/lockstep_loop.h"

#include <algorithm>
#include <utility>

#include "daemon/control/loop/absolute_sleep.h"
#include "daemon/control/loop/loop_meter.h"
#include "daemon/device/tick_clock.h"

namespace hedgehog::control {
namespace {

Pace in_range(const Pace& pace) noexcept {
  const int speed = std::clamp(pace.speed, 1, Pace::kMaxSpeed);
  return {speed, std::clamp(pace.step_ms, 1, std::min(Pace::kMaxStepMs, Pace::kMaxTicks / speed))};
}

}  // namespace

LockstepLoop::LockstepLoop(const ControlSettings& settings, Mailbox& mailbox,
                           device::LinkPort& port, FlightRecorder* recorder,
                           const device::SimulatedBoardOptions& board, Pace pace)
    : LockstepLoop(settings, mailbox, port, recorder, pace,
                   std::make_unique<device::LockStep>(port, board)) {}

LockstepLoop::LockstepLoop(const ControlSettings& settings, Mailbox& mailbox,
                           device::LinkPort& port, FlightRecorder* recorder, Pace pace,
                           std::unique_ptr<device::SteppedBoard> board)
    : Loop(settings, mailbox, port, recorder, in_range(pace).speed),
      pace_(in_range(pace)),
      board_(std::move(board)) {}

void LockstepLoop::run() noexcept {
  using device::monotonic_ns;
  model::Tick now = 0;
  const std::int64_t step_ns = pace_.step_ms * model::kNanosecondsPerTick;
  std::int64_t due_ns = monotonic_ns();
  LoopMeter meter(due_ns);
  while (!stopping()) {
    due_ns += step_ns;
    sleep_until_ns(due_ns);
    const std::int64_t woke_ns = monotonic_ns();
    meter.woke(woke_ns, woke_ns - due_ns);
    due_ns = std::max(due_ns, woke_ns - step_ns);
    for (int i = 0; i < pace_.ticks(); ++i) {
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
