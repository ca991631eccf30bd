// SPDX-License-Identifier: MIT
// Ownership of effects: numbers, places and slots of those whose end has not been reported yet.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "daemon/control/effects/command.h"
#include "daemon/server/effects/effect_plan.h"
#include "daemon/server/session/session.h"
#include "protocol/methods.h"

namespace hedgehog::server {

struct Effect {
  control::EffectId id = 0;  // 0: the place is free
  std::uint8_t place = 0;
  ConnectionId owner = 0;  // 0 after its connection has closed
  std::string client;
  std::optional<std::string> slot;
  EffectPlan plan;
  std::uint64_t seq = 0;   // of the command that started it
  bool replacing = false;  // it replaced an effect in its slot
  bool begun = false;      // its onset has passed
  bool ending = false;     // stopped or replaced; can no longer be addressed
};

/// io thread only.
class EffectRegistry {
 public:
  static constexpr int kMaxEach = 32;
  static constexpr int kReservedForNew = 8;  // places for connections without effects

  /// `last`: the last number already used.
  explicit EffectRegistry(control::EffectId last = 0) noexcept : last_id_(last) {}

  enum class Capacity : std::uint8_t { kYes, kConnectionFull, kDeviceFull, kPlacesFull };
  /// Capacity of `owner` for one more effect; `replacing`: it replaces one of its own.
  Capacity capacity(ConnectionId owner, bool replacing) const noexcept;

  /// Allocates a place and a number; valid until the effect ends. REQUIRES: capacity() is kYes.
  Effect& add(ConnectionId owner);
  /// Reverts an `add` whose command was rejected.
  void drop(const Effect& effect) noexcept { places_[effect.place] = {}; }

  /// nullptr: this owner has no such effect that can still be addressed.
  Effect* find(ConnectionId owner, control::EffectId id) noexcept;
  Effect* find(ConnectionId owner, std::string_view slot) noexcept;
  /// nullptr: unknown, or ended and reported.
  const Effect* at(std::uint8_t place, control::EffectId id) const noexcept;
  void begun(std::uint8_t place, control::EffectId id) noexcept;
  const Effect* any(control::EffectId id) const noexcept;

  /// All that can still be addressed; owner 0: of all owners.
  std::vector<Effect*> playing(ConnectionId owner = 0);
  /// The connection has closed: its effects lose their owner, and are returned.
  std::vector<Effect*> release_all(ConnectionId owner);

  /// `effect_ended` was read: frees the place and returns its effect.
  std::optional<Effect> ended(std::uint8_t place, control::EffectId id);

 private:
  std::array<Effect, control::kEffectPlaces> places_{};
  control::EffectId last_id_;
};

}  // namespace hedgehog::server
