// SPDX-License-Identifier: MIT
#include "clients/ctl/follow_arguments.h"
#include "cli/program.h"

namespace hedgehog::client {

void add_events_arguments(const cli::CommandSpec& events, EventsOptions& options) {
  events.add_option("--types", options.types, "only these types, separated by commas")
      .delimiter(',');
  events.add_option("--since", options.since,
                    "past events since then (yesterday, 2h, 23:14) instead of new ones");
  events.add_flag("-f,--follow", options.follow, "with --since: new events too");
  events.add_ignored_flag("--all");  // of everybody: always so
}

void add_pins_arguments(const cli::CommandSpec& pins, PinsOptions& options) {
  const cli::OptionSpec live = pins.add_flag(
      "--live", options.live, "repeatedly; on a terminal SPACE is the emergency stop, q quits");
  pins.add_option("--count", options.count, "with --live: ends after this number of lines")
      .needs(live);
}

void add_telemetry_arguments(const cli::CommandSpec& telemetry, TelemetryOptions& options) {
  telemetry.add_option("--rate-hz", options.rate_hz, "0.1..200").show_default();
  telemetry.add_option("--fields", options.fields, "keys of the status, separated by commas")
      .delimiter(',');
  telemetry.add_option("--count", options.count, "ends after this number");
}

}  // namespace hedgehog::client
