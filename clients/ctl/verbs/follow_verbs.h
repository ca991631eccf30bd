// SPDX-License-Identifier: MIT
// The verbs that follow: watch, events, telemetry. They end by Ctrl-C (or q), or when the daemon
// goes. Each returns the exit code.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "clients/ctl/verbs/session.h"

namespace hedgehog::client {

/// The ball as it lives, redrawn in place; SPACE is the emergency stop. Needs a terminal of 80x22.
int run_watch(Session& session);

struct EventsOptions {
  std::vector<std::string> types;
  /// As `since_rfc3339` reads it; nullopt: only what happens from now on.
  std::optional<std::string> since;
  /// With `since`: goes on with what happens, instead of ending.
  bool follow = false;
};
int run_events(Session& session, const EventsOptions& options);

struct TelemetryOptions {
  double rate_hz = 10.0;
  /// Keys of the status object; empty: all but `pins`.
  std::vector<std::string> fields;
  /// Ends after so many; 0: never.
  std::int64_t count = 0;
};
/// One JSON object a line.
int run_telemetry(Session& session, const TelemetryOptions& options);

}  // namespace hedgehog::client
