// SPDX-License-Identifier: MIT
// Textual form of an event.
#pragma once

#include <optional>
#include <string>

#include "protocol/values/event.h"

namespace hedgehog::client {

/// "effect_ended  #431 tap  stopped, 120 ms"; for `watch` and `events`.
std::string event_words(const protocol::Event& event);

/// " (winding y: current, supply_current)"; of none nothing.
std::string disagreement_words(const std::optional<protocol::Disagreement>& found);

}  // namespace hedgehog::client
