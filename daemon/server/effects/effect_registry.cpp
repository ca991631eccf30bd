// SPDX-License-Identifier: MIT
#include "daemon/server/effects/effect_registry.h"

#include <algorithm>
#include <utility>

namespace hedgehog::server {
namespace {

bool addressable(const Effect& e) { return e.id != 0 && !e.ending; }

}  // namespace

EffectRegistry::Capacity EffectRegistry::capacity(ConnectionId owner,
                                                  bool replacing) const noexcept {
  int used = 0;
  int playing = replacing ? -1 : 0;
  int own = playing;
  int own_ending = 0;
  bool is_new_owner = true;
  for (const Effect& e : places_) {
    used += e.id != 0 ? 1 : 0;
    is_new_owner &= e.id == 0 || e.owner != owner;
    own_ending += e.id != 0 && e.ending && e.owner == owner ? 1 : 0;
    playing += addressable(e) ? 1 : 0;
    own += addressable(e) && e.owner == owner ? 1 : 0;
  }
  if (own >= kMaxEach) return Capacity::kConnectionFull;
  if (playing >= control::kMaxEffects) return Capacity::kDeviceFull;
  // A client that replaces its effects faster than they can end leaves at least as many places to
  // others as its ending effects hold.
  const int free = control::kEffectPlaces - used;
  const int others = is_new_owner ? 0 : own_ending + kReservedForNew;
  return own_ending < kMaxEach && free > others ? Capacity::kYes : Capacity::kPlacesFull;
}

Effect& EffectRegistry::add(ConnectionId owner) {
  const auto free =
      std::find_if(places_.begin(), places_.end(), [](const Effect& e) { return e.id == 0; });
  if (++last_id_ == 0) ++last_id_;  // 0 marks a free place
  free->id = last_id_;
  free->place = static_cast<std::uint8_t>(free - places_.begin());
  free->owner = owner;
  return *free;
}

Effect* EffectRegistry::find(ConnectionId owner, control::EffectId id) noexcept {
  for (Effect& e : places_)
    if (addressable(e) && e.id == id && e.owner == owner) return &e;
  return nullptr;
}

Effect* EffectRegistry::find(ConnectionId owner, std::string_view slot) noexcept {
  for (Effect& e : places_)
    if (addressable(e) && e.owner == owner && e.slot == slot) return &e;
  return nullptr;
}

const Effect* EffectRegistry::at(std::uint8_t place, control::EffectId id) const noexcept {
  const Effect& e = places_[place];
  return e.id == id && id != 0 ? &e : nullptr;
}

void EffectRegistry::begun(std::uint8_t place, control::EffectId id) noexcept {
  Effect& e = places_[place];
  if (e.id == id) e.begun = true;
}

const Effect* EffectRegistry::any(control::EffectId id) const noexcept {
  for (const Effect& e : places_)
    if (addressable(e) && e.id == id) return &e;
  return nullptr;
}

std::vector<Effect*> EffectRegistry::playing(ConnectionId owner) {
  std::vector<Effect*> found;
  for (Effect& e : places_)
    if (addressable(e) && (owner == 0 || e.owner == owner)) found.push_back(&e);
  std::sort(found.begin(), found.end(), [](auto* a, auto* b) { return a->id < b->id; });
  return found;
}

std::vector<Effect*> EffectRegistry::release_all(ConnectionId owner) {
  std::vector<Effect*> found = playing(owner);
  for (Effect* e : found) {
    e->owner = 0;
    e->slot.reset();
  }
  return found;
}

std::optional<Effect> EffectRegistry::ended(std::uint8_t place, control::EffectId id) {
  if (at(place, id) == nullptr) return std::nullopt;
  return std::exchange(places_[place], {});
}

}  // namespace hedgehog::server
