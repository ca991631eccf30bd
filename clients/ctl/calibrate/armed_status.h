// SPDX-License-Identifier: MIT
// Telemetry of a ball that a measurement drives: what both benches subscribe to and read.
#pragma once

#include <initializer_list>
#include <string>

#include "clients/ctl/verbs/session.h"
#include "protocol/values/status.h"

namespace hedgehog::client {

ClientError measuring_failed(const std::string& message);

/// "the ball is tripped: …", with the remedy.
ClientError not_armed(const protocol::Status& status);

/// Telemetry of the state and `keys`; takes the place of the subscription before.
Outcome<void> subscribe(Session& session, double rate_hz,
                        std::initializer_list<protocol::StatusKey> keys);

/// The next status that telemetry brings, of whatever state; an error when none comes for 3 s, or
/// on Ctrl-C.
Outcome<protocol::Status> next_status(Session& session);

}  // namespace hedgehog::client
