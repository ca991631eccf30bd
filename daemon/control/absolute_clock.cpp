// SPDX-License-Identifier: MIT
#include "daemon/control/absolute_clock.h"

#include <pthread.h>
#include <sched.h>

#include <cerrno>
#include <ctime>

namespace hedgehog::control {
namespace {

constexpr std::int64_t kSecond = 1'000'000'000;

}  // namespace

std::int64_t monotonic_ns() noexcept {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return now.tv_sec * kSecond + now.tv_nsec;
}

void sleep_until_ns(std::int64_t ns) noexcept {
  const timespec until{ns / kSecond, ns % kSecond};
  while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &until, nullptr) == EINTR) {
  }
}

bool make_realtime(std::thread& thread, int priority) noexcept {
  sched_param parameters{};
  parameters.sched_priority = priority;
  return pthread_setschedparam(thread.native_handle(), SCHED_FIFO, &parameters) == 0;
}

void name_thread(std::thread& thread, const char* name) noexcept {
  pthread_setname_np(thread.native_handle(), name);
}

}  // namespace hedgehog::control
