// SPDX-License-Identifier: MIT
// CLOCK_MONOTONIC as nanoseconds, and real-time scheduling, for the threads that keep time. Linux.
#pragma once

#include <cstdint>
#include <thread>

namespace hedgehog::control {

/// Any thread.
std::int64_t monotonic_ns() noexcept;
/// Sleeps until then; at once when it is past.
void sleep_until_ns(std::int64_t ns) noexcept;
/// SCHED_FIFO at `priority` for a thread of this process. False: not permitted.
bool make_realtime(std::thread& thread, int priority) noexcept;
/// The name that top and debuggers show, at most 15 characters.
void name_thread(std::thread& thread, const char* name) noexcept;

}  // namespace hedgehog::control
