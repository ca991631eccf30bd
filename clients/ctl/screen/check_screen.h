// SPDX-License-Identifier: MIT
// `hedgehogctl check`: output line and exit code of a monitoring plug-in.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "clients/ctl/screen/ball.h"

namespace hedgehog::client {

/// Limit of the p99 lateness of the 1 kHz loop, µs, over about the last ten seconds. Same limit as
/// in the metrics' alarm.
inline constexpr double kLateUs = 500.0;

struct Check {
  /// 0 ok, 1 warning: derated, disarmed, no temperature, loop late, 2 critical: tripped or absent.
  int code = 0;
  /// "HEDGEHOG OK - ball-7 armed, hottest winding 41.2 C, 15.0 A allowed | temperature=41.2;60;70
  /// thermistor=38.3 ...".
  std::string line;
};

/// `clients`: number of other connections; nullopt: not permitted to list them.
Check check_screen(const Ball& ball, std::optional<std::size_t> clients);

}  // namespace hedgehog::client
