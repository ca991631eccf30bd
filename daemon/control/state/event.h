// SPDX-License-Identifier: MIT
// Events of the control thread. Trivially copyable; control -> io by spsc queue.
#pragma once

#include <cstdint>
#include <string_view>
#include <type_traits>

#include "daemon/control/effects/command.h"
#include "daemon/control/state/disagreement.h"
#include "daemon/control/state/state.h"
#include "model/tick.h"

namespace hedgehog::control {

enum class EventType : std::uint8_t {
  kEffectStarted,
  kEffectEnded,
  kStateChanged,
  kDeratingStarted,
  kDeratingEnded,
  kOrientationLost,
  kOrientationRestored,
  kMeasurementRejected,
  kMeasurementAccepted,
  kDeviceAttached,
  kDeviceDetached,
  kOverrun,
  kRejectedNumber,  // a non-finite number was replaced by zero current
};

enum class EndReason : std::uint8_t {
  kCompleted,
  kStopped,
  kReplaced,
  kPreempted,  // ended after being masked by effects of higher priority in every tick
  kExpired,    // the lease expired
  kDisconnected,
  kTripped,  // also by emergency stop or disarming
  kOrientationLost,
};

/// Delivery of an effect: the limiter's output over the request of its own shape, per tick (a
/// request of 0 counts as 1).
struct Delivery {
  model::Tick onset = -1;  // first tick in which it played; -1: never
  model::Tick offset = -1;
  double min = 1.0;
  double mean = 1.0;
  model::Tick masked = 0;  // ticks masked by a higher priority
  model::Tick mixed = 0;   // ticks in which others were added to it
};

struct Event {
  EventType type = EventType::kStateChanged;
  EndReason end_reason = EndReason::kCompleted;
  State state = State::kAbsent;
  Reason reason = Reason::kNone;
  std::uint8_t place = 0;
  EffectId effect = 0;
  std::uint64_t seq = 0;  // kEffectStarted: the command that started it
  model::Tick tick = 0;
  Delivery delivery;
  /// kStateChanged: tripped in this tick, or the board was lost while armed; false for an already
  /// existing latch.
  bool trip = false;
  /// The allowed and the measured current, A, and the hottest temperature, C (infinite: unknown).
  /// kOverrun: skipped ticks in `count`.
  double limit_a = 0.0;
  double current_a = 0.0;
  double temperature_c = 0.0;
  std::uint64_t count = 0;
  /// kStateChanged by a trip: that of the trip. kMeasurementRejected, kMeasurementAccepted: the
  /// measurement and the heat balance.
  Disagreement disagreement;
};

static_assert(std::is_trivially_copyable_v<Event>);

/// Names on the wire (protocol/README.md).
std::string_view name(EventType type) noexcept;
std::string_view name(EndReason reason) noexcept;

}  // namespace hedgehog::control
