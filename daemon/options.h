// SPDX-License-Identifier: MIT
// The command line of hedgehogd.
#pragma once

#include <optional>
#include <string>
#include <variant>

#include "daemon/config/load_config.h"
#include "daemon/control/loop/pace.h"

namespace hedgehog::daemon {

struct Options {
  std::optional<std::string> config_file;
  bool check_config = false;
  bool print_config = false;
  std::optional<std::string> replay;
  /// Ticks of device time per millisecond, in lock-step; only with --simulate.
  std::optional<int> speed;
  /// Real time from one step of the simulation to the next, ms; only with `speed`.
  std::optional<int> step_ms;
  config::Overrides overrides;

  /// Of the lock-step, if it is requested.
  std::optional<control::Pace> pace() const {
    if (!speed) return {};
    return control::Pace{*speed, step_ms.value_or(1)};
  }
};

/// The options, or the exit code if nothing is left to do (--help, --version, a usage error).
std::variant<Options, int> parse_options(int argc, const char* const* argv);

}  // namespace hedgehog::daemon
