// SPDX-License-Identifier: MIT
#include "daemon/server/rpc/known_counters.h"

#include <cstddef>

#include "daemon/control/state/event.h"
#include "daemon/control/state/state.h"
#include "protocol/methods.h"

namespace hedgehog::server {
namespace {

void add_effects(Counters& counters) {
  constexpr auto kEndReasons = static_cast<std::size_t>(control::EndReason::kOrientationLost) + 1;
  for (const protocol::MethodInfo& method : protocol::EffectStart::kMethods) {
    for (std::size_t i = 0; i < kEndReasons; ++i)
      counters.effects[{method.name, control::name(static_cast<control::EndReason>(i))}] = 0;
    counters.effects[{method.name, "refused"}] = 0;
  }
  for (const char* by : {"thermal", "mix", "priority", "configuration"}) counters.limited[by] = 0;
}

void add_trips(Counters& counters) {
  // The board was lost while armed.
  counters.trips[control::name(control::Reason::kNoBoard)] = 0;
  constexpr auto kLast = static_cast<std::size_t>(control::Reason::kInternal);
  for (auto i = static_cast<std::size_t>(control::Reason::kOverheated); i <= kLast; ++i)
    counters.trips[control::name(static_cast<control::Reason>(i))] = 0;
}

}  // namespace

Counters known_counters() {
  Counters counters;
  add_effects(counters);
  add_trips(counters);
  for (const char* why : {"cap", "slow", "not_json", "host", "origin", "token", "tls"})
    counters.rejected[why] = 0;
  return counters;
}

}  // namespace hedgehog::server
