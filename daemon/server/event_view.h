// SPDX-License-Identifier: MIT
// From what the control thread reports to what subscribers are told.
#pragma once

#include <cstdint>
#include <optional>

#include "daemon/control/event.h"
#include "daemon/server/effect_registry.h"
#include "daemon/server/remedy.h"
#include "protocol/event.h"

namespace hedgehog::server {

/// `effect`: whose event it is, for the two effect events (nullptr: no longer known). nullopt: not
/// for clients.
std::optional<protocol::Event> event_view(const control::Event& event, const Effect* effect,
                                          std::int64_t epoch_ns, const RemedyFacts& facts);

}  // namespace hedgehog::server
