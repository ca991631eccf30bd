// SPDX-License-Identifier: MIT
// Events of the control thread -> notifications of the protocol.
#pragma once

#include <cstdint>
#include <optional>

#include "daemon/control/state/event.h"
#include "daemon/server/device/remedy.h"
#include "daemon/server/effects/effect_registry.h"
#include "protocol/values/event.h"

namespace hedgehog::server {

/// nullopt if there is none.
std::optional<protocol::Disagreement> disagreement_view(const control::Disagreement& found);

/// `effect`: of an effect event; nullptr: no longer known. nullopt: not sent to clients.
std::optional<protocol::Event> event_view(const control::Event& event, const Effect* effect,
                                          std::int64_t epoch_ns, const RemedyFacts& facts);

}  // namespace hedgehog::server
