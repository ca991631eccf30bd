// SPDX-License-Identifier: MIT
#include "daemon/device/tick_clock.h"

#include <pthread.h>
#include <sched.h>
#include <signal.h>
#include <sys/prctl.h>
#include <time.h>

#include <cstring>

namespace hedgehog::device {
namespace {

constexpr std::int64_t kNanosecondsPerSecond = 1'000'000'000;

static_assert(sizeof(sigset_t) <= 128);

}  // namespace

std::int64_t monotonic_ns() noexcept {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return now.tv_sec * kNanosecondsPerSecond + now.tv_nsec;
}

TickClock::TickClock(std::int64_t period_ns) noexcept
    : period_ns_(period_ns), due_ns_(monotonic_ns()) {}

TickClock TickClock::at_phase(std::int64_t phase_ns) noexcept {
  TickClock clock;
  // From the next one on, so that the first tick is not early.
  clock.due_ns_ = at_phase_before(clock.due_ns_, phase_ns) + clock.period_ns_;
  return clock;
}

std::uint64_t TickClock::wait(int ticks) noexcept {
  due_ns_ += ticks * period_ns_;
  std::uint64_t skipped = 0;
  const std::int64_t behind = (monotonic_ns() - due_ns_) / period_ns_;
  if (behind > kCatchUp) {
    skipped = static_cast<std::uint64_t>(behind);
    due_ns_ += behind * period_ns_;
  }
  const timespec until{due_ns_ / kNanosecondsPerSecond, due_ns_ % kNanosecondsPerSecond};
  while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &until, nullptr) != 0) {
  }
  lateness_ns_ = monotonic_ns() - due_ns_;
  return skipped;
}

bool use_fifo(int priority) noexcept {
  prctl(PR_SET_TIMERSLACK, 1, 0, 0, 0);
  sched_param parameters{};
  parameters.sched_priority = priority;
  return pthread_setschedparam(pthread_self(), SCHED_FIFO, &parameters) == 0;
}

SignalsBlocked::SignalsBlocked() noexcept {
  sigset_t all;
  sigset_t before;
  sigfillset(&all);
  pthread_sigmask(SIG_SETMASK, &all, &before);
  std::memcpy(saved_, &before, sizeof before);
}

SignalsBlocked::~SignalsBlocked() {
  sigset_t before;
  std::memcpy(&before, saved_, sizeof before);
  pthread_sigmask(SIG_SETMASK, &before, nullptr);
}

}  // namespace hedgehog::device
