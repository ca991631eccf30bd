// SPDX-License-Identifier: MIT
// The wire names of the protocol's enumerations, in the order of the enumerators.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "protocol/requests.h"

namespace hedgehog::protocol {

using Names = std::span<const std::string_view>;

Names names_of(Role) noexcept;
Names names_of(Word) noexcept;
Names names_of(Scope) noexcept;
Names names_of(OnClose) noexcept;
Names names_of(IfLimited) noexcept;
Names names_of(Sense) noexcept;
Names names_of(Stepping) noexcept;
Names names_of(StatusKey) noexcept;
Names names_of(model::Frame) noexcept;
Names names_of(model::Waveform) noexcept;
Names names_of(model::Ease) noexcept;
/// By their wire names: effect.pulse, effect.circle, ...
Names names_of(model::EffectMethod) noexcept;

/// The one of `names` that was probably meant by `text`; empty when none is near.
std::string_view nearest(std::string_view text, Names names);
/// What a message repeats of something long that was sent: its first 64 bytes at most, and "…".
std::string shortened(std::string_view text);
/// "; did you mean 'x'?", or the names there are when they are few, or nothing.
std::string hint(std::string_view text, Names names);

}  // namespace hedgehog::protocol
