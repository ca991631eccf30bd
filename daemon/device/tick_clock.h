// SPDX-License-Identifier: MIT
// Period of a real-time thread: absolute sleeps on CLOCK_MONOTONIC, and its scheduling class.
#pragma once

#include <cstdint>

namespace hedgehog::device {

/// One thread. No bursts: when it is more than `kCatchUp` ticks late, they are skipped and counted.
class TickClock {
 public:
  static constexpr std::int64_t kCatchUp = 3;

  explicit TickClock(std::int64_t period_ns = 1'000'000) noexcept;
  static TickClock at_phase(std::int64_t phase_ns) noexcept;  // after each whole millisecond

  /// Sleeps until the next tick, or `ticks` ticks. Returns how many were skipped for lateness.
  std::uint64_t wait(int ticks = 1) noexcept;
  std::int64_t lateness_ns() const noexcept { return lateness_ns_; }  // of the last `wait`

 private:
  std::int64_t period_ns_;
  std::int64_t due_ns_;
  std::int64_t lateness_ns_ = 0;
};

std::int64_t monotonic_ns() noexcept;  // CLOCK_MONOTONIC

/// The latest time not after `now_ns` that is `phase_ns` after a whole millisecond.
constexpr std::int64_t at_phase_before(std::int64_t now_ns, std::int64_t phase_ns) noexcept {
  constexpr std::int64_t kMillisecond = 1'000'000;
  return now_ns - (now_ns - phase_ns) % kMillisecond;
}

/// A set-point is sent soon after its tick, without one thread waking another; a late one in the
/// next millisecond.
inline constexpr std::int64_t kControlPhaseNs = 250'000;
inline constexpr std::int64_t kLinkPhaseNs = kControlPhaseNs + 100'000;

/// Priorities of SCHED_FIFO (daemon/threads.md).
inline constexpr int kControlPriority = 50;
inline constexpr int kLinkPriority = 49;
inline constexpr int kSimulatedBoardPriority = 48;

/// Sets SCHED_FIFO for the calling thread; false if the system does not allow it. Its sleeps end
/// without the 50 us by which the kernel delays those of normal threads (timer slack).
bool use_fifo(int priority) noexcept;

/// Blocks all signals in the calling thread and those it starts until destroyed: io handles them.
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
