// SPDX-License-Identifier: MIT
// An event in words.
#pragma once

#include <string>

#include "protocol/values/event.h"

namespace hedgehog::client {

/// One event in words: "effect_ended  #431 tap  stopped, 120 ms"; for `watch` and `events`.
std::string event_words(const protocol::Event& event);

}  // namespace hedgehog::client
