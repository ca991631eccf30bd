// SPDX-License-Identifier: MIT
// The verbs that print information: status, clients, devices, trips, forecast, check. Each returns
// the exit code.
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
  /// In the format of `direction_json`; empty: the worst coil.
  std::string direction;
};
int run_forecast(Session& session, const ForecastOptions& options);

/// Output of a monitoring plug-in: one line, 0 ok, 1 warning, 2 critical, 3 unknown. Opens its own
/// connection, because a missing daemon is a valid result. --json: the same as an object,
/// `check_json`.
int run_check(const CommonOptions& options);
/// Prints "HEDGEHOG UNKNOWN - <what>" and returns 3, when `check` cannot determine the state.
int print_unknown(const std::string& what, bool as_json);

}  // namespace hedgehog::client
