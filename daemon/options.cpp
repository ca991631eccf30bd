// SPDX-License-Identifier: MIT
#include "daemon/options.h"

#include <sysexits.h>

#include <fmt/format.h>

#include <iostream>

#include "cli/program.h"

namespace hedgehog::daemon {
namespace {

constexpr const char* kAbout =
    "hedgehogd owns one Hedgehog ball: it plays the effects that clients request over JSON-RPC and "
    "keeps\n"
    "the coils cool. Runs in the foreground. Without a configuration file it simulates a ball.";
constexpr const char* kVersion = "hedgehogd " HEDGEHOG_VERSION ", protocol 1.0";

}  // namespace

std::variant<Options, int> parse_options(int argc, const char* const* argv) {
  Options options;
  config::Overrides& overrides = options.overrides;
  cli::Program app(kAbout, "hedgehogd");
  app.add_option("--config", options.config_file, "read this configuration file")
      .type_name("F")
      .environment("HEDGEHOG_CONFIG");
  app.add_flag("--check-config", options.check_config,
               "check the configuration and exit: 0, or 78 and what is wrong");
  app.add_flag("--print-config", options.print_config, "print every key and its value in effect");
  app.add_option("--replay", options.replay,
                 "replay a recording (a file, or trip-0001); prints JSON lines")
      .type_name("F");
  app.add_flag("--simulate", overrides.simulate, "a simulated ball, overriding the configuration");
  app.add_option("--speed", options.speed,
                 "with --simulate: in lock-step, N times real time, 1 to 100")
      .type_name("N")
      .range(1, control::Pace::kMaxSpeed);
  app.add_option(
         "--step-ms", options.step_ms,
         "with --speed: M ms at a time, 1 to 20, N times M at most 100: less processor time "
         "for many balls on a machine, but requests take effect up to M ms later")
      .type_name("M")
      .range(1, control::Pace::kMaxStepMs);
  app.add_option("--listen", overrides.listen,
                 "instead of 127.0.0.1:7586 and [::1]:7586; tls://A:P, and whatever other machines "
                 "can reach: with TLS and tokens; port 0 takes a free one and prints it")
      .type_name("A:P")
      .repeatable();
  app.add_option("--log-level", overrides.log_level, "debug, info, warning or error")
      .type_name("LEVEL")
      .environment("HEDGEHOG_LOG_LEVEL");
  app.set_version(kVersion);
  constexpr int kAdministratorSection = 8;
  if (const auto code = app.parse_and_print(argc, argv, kAdministratorSection)) return *code;
  if (options.speed && !overrides.simulate) {
    std::cerr << app.usage_error("--speed: only with --simulate: a real ball keeps real time")
              << "\n";
    return EX_USAGE;
  }
  if (options.step_ms && !options.speed) {
    std::cerr << app.usage_error("--step-ms: only with --speed") << "\n";
    return EX_USAGE;
  }
  if (options.step_ms && options.pace()->ticks() > control::Pace::kMaxTicks) {
    std::cerr << app.usage_error(fmt::format("--step-ms: {} with --speed {}, at most {}",
                                             *options.step_ms, *options.speed,
                                             control::Pace::kMaxTicks / *options.speed))
              << "\n";
    return EX_USAGE;
  }
  return options;
}

}  // namespace hedgehog::daemon
