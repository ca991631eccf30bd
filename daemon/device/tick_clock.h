// SPDX-License-Identifier: MIT
// Period of a real-time thread: absolute sleeps on CLOCK_MONOTONIC, and its scheduling class.
#pragma once

#include <cstdint>

namespace hedgehog::device {

/// One thread. A late thread never catches up in a burst: when more than `kCatchUp` ticks late, the
/// missed ticks are skipped and counted.
class TickClock {
 public:
  static constexpr std::int64_t kCatchUp = 3;

  explicit TickClock(std::int64_t period_ns = 1'000'000) noexcept;
  /// Ticks are `phase_ns` after each whole millisecond of CLOCK_MONOTONIC.
  static TickClock at_phase(std::int64_t phase_ns) noexcept;

  /// Sleeps until the next tick is due, or `ticks` ticks. Returns the number of further ticks that
  /// were skipped because the thread was late.
  std::uint64_t wait(int ticks = 1) noexcept;
  /// Lateness of the last `wait`, ns.
  std::int64_t lateness_ns() const noexcept { return lateness_ns_; }

 private:
  std::int64_t period_ns_;
  std::int64_t due_ns_;
  std::int64_t lateness_ns_ = 0;
};

/// CLOCK_MONOTONIC, nanoseconds.
std::int64_t monotonic_ns() noexcept;

/// The latest time not after `now_ns` that is `phase_ns` after a whole millisecond.
constexpr std::int64_t at_phase_before(std::int64_t now_ns, std::int64_t phase_ns) noexcept {
  constexpr std::int64_t kMillisecond = 1'000'000;
  return now_ns - (now_ns - phase_ns) % kMillisecond;
}

/// A set-point is sent soon after the tick that computed it, without one thread waking another.
/// That of a late tick is sent a millisecond later.
inline constexpr std::int64_t kControlPhaseNs = 250'000;
inline constexpr std::int64_t kLinkPhaseNs = kControlPhaseNs + 100'000;

/// Priorities of SCHED_FIFO (daemon/threads.md).
inline constexpr int kControlPriority = 50;
inline constexpr int kLinkPriority = 49;
inline constexpr int kSimulatedBoardPriority = 48;

/// Sets SCHED_FIFO for the calling thread; false if the system does not allow it. Then its sleeps
/// end without the 50 us by which the kernel delays those of normal threads (timer slack).
bool use_fifo(int priority) noexcept;

/// Signals are handled by the io thread: blocks all of them in the calling thread, so that threads
/// it starts inherit the mask, and restores it in the destructor.
class SignalsBlocked {
 public:
  SignalsBlocked() noexcept;
  SignalsBlocked(const SignalsBlocked&) = delete;
  SignalsBlocked& operator=(const SignalsBlocked&) = delete;
  ~SignalsBlocked();

 private:
  unsigned char saved_[128];  // a sigset_t, without including its header here
};

}  // namespace hedgehog::device
