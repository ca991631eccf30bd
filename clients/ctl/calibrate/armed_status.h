// SPDX-License-Identifier: MIT
// Telemetry of a ball that is driven for a measurement, shared by both benches.
#pragma once

#include <initializer_list>
#include <string>

#include "clients/ctl/verbs/session.h"
#include "protocol/values/status.h"

namespace hedgehog::client {

ClientError measuring_failed(const std::string& message);

/// "the ball is tripped: …", with the remedy.
ClientError not_armed(const protocol::Status& status);

/// Telemetry of the state and `keys`; replaces the previous subscription.
Outcome<void> subscribe(Session& session, double rate_hz,
                        std::initializer_list<protocol::StatusKey> keys);

/// The next status from telemetry, in any state; an error if none is received for 3 s, or on
/// Ctrl-C.
Outcome<protocol::Status> next_status(Session& session);

}  // namespace hedgehog::client
