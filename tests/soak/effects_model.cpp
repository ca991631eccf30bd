// SPDX-License-Identifier: MIT
#include "tests/soak/effects_model.h"

#include "tests/soak/failure.h"

namespace hedgehog::soak {

void EffectsModel::admitted(std::uint32_t effect) {
  // The end may have been reported before the response was read.
  if (!ended_.contains(effect)) open_.insert(effect);
}

void EffectsModel::event(const protocol::Json& params) {
  const std::string type = *params.find("type")->as<std::string>();
  if (type != "effect_started" && type != "effect_ended") return;
  const auto effect = static_cast<std::uint32_t>(*params.find("effect")->as<std::int64_t>());
  if (ended_.contains(effect))
    throw Failure("an event of an effect that has ended: " + protocol::to_text(params));
  if (type == "effect_started") {
    if (!started_.insert(effect).second)
      throw Failure("an effect started twice: " + protocol::to_text(params));
    open_.insert(effect);
  } else {
    ended_.insert(effect);
    open_.erase(effect);
  }
}

std::string EffectsModel::active() const {
  std::string text;
  for (const std::uint32_t effect : open_) text += " " + std::to_string(effect);
  return text;
}

}  // namespace hedgehog::soak
