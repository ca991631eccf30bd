// SPDX-License-Identifier: MIT
// Period of a real-time thread: absolute sleeps on CLOCK_MONOTONIC, and its scheduling class.
#pragma once

#include <cstdint>

namespace hedgehog::device {

/// One thread. A late thread is never made to catch up in a burst: what it missed by more than
/// `kCatchUp` ticks is left out and counted.
class TickClock {
 public:
  static constexpr std::int64_t kCatchUp = 3;

  explicit TickClock(std::int64_t period_ns = 1'000'000) noexcept;
  /// Its ticks are `phase_ns` after each whole millisecond of CLOCK_MONOTONIC.
  static TickClock at_phase(std::int64_t phase_ns) noexcept;

  /// Sleeps until the next tick is due, or that many ticks on purpose. Returns how many more were
  /// left out because the thread was late.
  std::uint64_t wait(int ticks = 1) noexcept;
  /// How late the last `wait` woke, nanoseconds.
  std::int64_t lateness_ns() const noexcept { return lateness_ns_; }

 private:
  std::int64_t period_ns_;
  std::int64_t due_ns_;
  std::int64_t lateness_ns_ = 0;
};

/// CLOCK_MONOTONIC, nanoseconds.
std::int64_t monotonic_ns() noexcept;

/// The newest point up to `now_ns` that is `phase_ns` after a whole millisecond.
constexpr std::int64_t at_phase_before(std::int64_t now_ns, std::int64_t phase_ns) noexcept {
  constexpr std::int64_t kMillisecond = 1'000'000;
  return now_ns - (now_ns - phase_ns) % kMillisecond;
}

/// A set-point goes out soon after the tick that made it, without a thread that wakes another. What
/// a late tick makes goes out a millisecond later.
inline constexpr std::int64_t kControlPhaseNs = 250'000;
inline constexpr std::int64_t kLinkPhaseNs = kControlPhaseNs + 100'000;

/// Priorities of SCHED_FIFO (daemon/threads.md).
inline constexpr int kControlPriority = 50;
inline constexpr int kLinkPriority = 49;
inline constexpr int kSimulatedBoardPriority = 48;

/// The calling thread becomes SCHED_FIFO; false (and unchanged) when the system does not allow it.
bool use_fifo(int priority) noexcept;

/// Signals are for the io thread: blocks all of them in the calling thread, so that threads it
/// starts inherit that, and restores the mask when it goes.
class SignalsBlocked {
 public:
  SignalsBlocked() noexcept;
  SignalsBlocked(const SignalsBlocked&) = delete;
  SignalsBlocked& operator=(const SignalsBlocked&) = delete;
  ~SignalsBlocked();

 private:
  unsigned char saved_[128];  // a sigset_t; its header stays out of ours
};

}  // namespace hedgehog::device
