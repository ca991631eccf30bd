// SPDX-License-Identifier: MIT
// The verbs that look: status, clients, devices, trips, forecast, check. Each returns the exit
// code.
#pragma once

#include <optional>
#include <string>

#include "clients/ctl/verbs/session.h"

namespace hedgehog::client {

int run_status(Session& session);
int run_clients(Session& session);
int run_devices(Session& session);
int run_trips(Session& session);

struct ForecastOptions {
  double current_a = 15.0;
  /// As `direction_json` reads it; empty: the worst coil.
  std::string direction;
};
int run_forecast(Session& session, const ForecastOptions& options);

/// Speaks the monitoring plug-ins' language: one line, 0 ok, 1 warning, 2 critical, 3 unknown.
/// Opens its own connection, because no daemon is an answer too.
/// --json: the same as an object, `check_json`.
int run_check(const CommonOptions& options);
/// What `check` prints and returns when it cannot know: "HEDGEHOG UNKNOWN - <what>", 3.
int print_unknown(const std::string& what, bool as_json);

}  // namespace hedgehog::client
