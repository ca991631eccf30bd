// SPDX-License-Identifier: MIT
// `hedgehogctl check`: the monitoring plug-ins' one line and exit code.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "clients/ctl/screen/ball.h"

namespace hedgehog::client {

/// A loop of 1 kHz whose ticks come later than this is late: one in a hundred of the last ten
/// seconds or so. The same bound as the alarm on the metrics.
inline constexpr double kLateUs = 500.0;

struct Check {
  /// 0 ok, 1 warning: derated, disarmed, no temperature, loop late, 2 critical: tripped or gone.
  int code = 0;
  /// "HEDGEHOG OK - ball-7 armed, hottest winding 41.2 C, 15.0 A allowed | temperature=41.2;60;70
  /// thermistor=38.3 ...".
  std::string line;
};

/// `clients`: how many others are connected; nothing: this one may not know.
Check check_screen(const Ball& ball, std::optional<std::size_t> clients);

}  // namespace hedgehog::client
