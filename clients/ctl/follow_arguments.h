// SPDX-License-Identifier: MIT
// The arguments of the verbs that follow the ball continuously: `events`, `pins`, `telemetry`.
#pragma once

#include "cli/program.h"
#include "clients/ctl/verbs/follow_verbs.h"
#include "clients/ctl/verbs/pins_verb.h"

namespace hedgehog::client {

/// `options` must outlive the verb.
void add_events_arguments(const cli::CommandSpec& events, EventsOptions& options);
void add_pins_arguments(const cli::CommandSpec& pins, PinsOptions& options);
void add_telemetry_arguments(const cli::CommandSpec& telemetry, TelemetryOptions& options);

}  // namespace hedgehog::client
