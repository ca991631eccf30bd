// SPDX-License-Identifier: MIT
// The verbs that run continuously: watch, events, telemetry. They end by Ctrl-C (or q), or when the
// connection ends. Each returns the exit code.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "clients/ctl/verbs/session.h"

namespace hedgehog::client {

/// The ball live, redrawn in place; SPACE is the emergency stop. Needs a terminal of 80x22.
int run_watch(Session& session);

struct EventsOptions {
  std::vector<std::string> types;
  /// In the format of `since_rfc3339`; nullopt: only new events.
  std::optional<std::string> since;
  /// With `since`: continues with new events instead of ending.
  bool follow = false;
};
int run_events(Session& session, const EventsOptions& options);

struct TelemetryOptions {
  double rate_hz = 10.0;
  /// Keys of the status object; empty: all but `pins`.
  std::vector<std::string> fields;
  /// Ends after this many messages; 0: never.
  std::int64_t count = 0;
};
/// Prints one JSON object per line.
int run_telemetry(Session& session, const TelemetryOptions& options);

}  // namespace hedgehog::client
