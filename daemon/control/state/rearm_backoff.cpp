// SPDX-License-Identifier: MIT
#include "daemon/control/state/rearm_backoff.h"

#include <algorithm>
#include <limits>

namespace hedgehog::control {
namespace {

// An emergency stop latches too, but is not a fault.
bool is_trip(Reason latch) noexcept {
  return latch != Reason::kNone && latch != Reason::kEmergencyStop;
}

}  // namespace

void RearmBackoff::trip(model::Tick now) noexcept { tripped_at_ = now; }

void RearmBackoff::arm(Reason latch, model::Tick now) noexcept {
  quiet_since_ = now;
  if (!is_trip(latch)) return;
  std::uint8_t& count = counts_[static_cast<std::size_t>(latch)];
  if (count < std::numeric_limits<std::uint8_t>::max()) ++count;
}

void RearmBackoff::step(bool armed, model::Tick now) noexcept {
  if (!armed) quiet_since_ = now;
  if (now - quiet_since_ < kResetAfter) return;
  quiet_since_ = now;
  for (std::uint8_t& count : counts_) count = static_cast<std::uint8_t>(std::max(0, count - 1));
}

model::Tick RearmBackoff::wait(Reason latch, model::Tick now) const noexcept {
  if (!is_trip(latch)) return 0;
  const int beyond = counts_[static_cast<std::size_t>(latch)] - kFreeRearms;
  if (beyond < 0) return 0;
  constexpr int kMaxDoublings = 6;
  const model::Tick whole = std::min(kMaxWait, kFirstWait << std::min(beyond, kMaxDoublings));
  return std::max<model::Tick>(0, tripped_at_ + whole - now);
}

}  // namespace hedgehog::control
