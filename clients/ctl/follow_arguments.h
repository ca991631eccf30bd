// SPDX-License-Identifier: MIT
// The arguments of the verbs that follow the ball continuously: `events`, `pins`, `telemetry`.
#pragma once

#include "clients/ctl/verbs/follow_verbs.h"
#include "clients/ctl/verbs/pins_verb.h"

namespace CLI {  // NOLINT(readability-identifier-naming): CLI11 calls it so
class App;
}

namespace hedgehog::client {

/// `options` must outlive the verb.
void add_events_arguments(CLI::App& events, EventsOptions& options);
void add_pins_arguments(CLI::App& pins, PinsOptions& options);
void add_telemetry_arguments(CLI::App& telemetry, TelemetryOptions& options);

}  // namespace hedgehog::client
