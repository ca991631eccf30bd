// SPDX-License-Identifier: MIT
#include "clients/ctl/follow_arguments.h"

#include <CLI/CLI.hpp>

namespace hedgehog::client {

void add_events_arguments(CLI::App& events, EventsOptions& options) {
  events.add_option("--types", options.types, "only these types, separated by commas")
      ->delimiter(',');
  events.add_option("--since", options.since,
                    "past events since then (yesterday, 2h, 23:14) instead of new ones");
  events.add_flag("-f,--follow", options.follow, "with --since: new events too");
  events.add_flag("--all")->description("everybody's effects: always so")->group("");
}

void add_pins_arguments(CLI::App& pins, PinsOptions& options) {
  CLI::Option* live = pins.add_flag(
      "--live", options.live, "repeatedly; on a terminal SPACE is the emergency stop, q quits");
  pins.add_option("--count", options.count, "with --live: ends after this number of lines")
      ->needs(live);
}

void add_telemetry_arguments(CLI::App& telemetry, TelemetryOptions& options) {
  telemetry.add_option("--rate-hz", options.rate_hz, "0.1..200")->capture_default_str();
  telemetry.add_option("--fields", options.fields, "keys of the status, separated by commas")
      ->delimiter(',');
  telemetry.add_option("--count", options.count, "ends after this number");
}

}  // namespace hedgehog::client
