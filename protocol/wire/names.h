// SPDX-License-Identifier: MIT
// The wire names of enumerations, in the order of the enumerators. Those of the value types are
// declared with them.
#pragma once

#include <algorithm>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "model/effect/effect.h"
#include "model/effect/keyframes.h"
#include "protocol/wire/direction.h"
#include "protocol/wire/role.h"

namespace hedgehog::protocol {

using Names = std::span<const std::string_view>;

Names names_of(Role) noexcept;
Names names_of(Word) noexcept;
Names names_of(model::Frame) noexcept;
Names names_of(model::Waveform) noexcept;
Names names_of(model::Ease) noexcept;
/// Wire names: effect.pulse, effect.circle, ...
Names names_of(model::EffectMethod) noexcept;

std::string_view name(model::Frame frame) noexcept;
std::string_view name(model::Waveform waveform) noexcept;
std::string_view name(model::Ease ease) noexcept;

/// nullopt: unknown name.
template <class Enum>
std::optional<Enum> enumerator_named(std::string_view text) noexcept {
  const Names names = names_of(Enum{});
  const auto found = std::find(names.begin(), names.end(), text);
  if (found == names.end()) return std::nullopt;
  return static_cast<Enum>(found - names.begin());
}

/// The best match of `names` for a misspelt `text`; empty if none is close.
std::string_view nearest(std::string_view text, Names names);
/// `text` for a message: if long, at most its first 64 bytes and "…".
std::string shortened(std::string_view text);
/// "; did you mean 'x'?", or the list of names if there are few, or empty.
std::string hint(std::string_view text, Names names);

}  // namespace hedgehog::protocol
