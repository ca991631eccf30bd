// SPDX-License-Identifier: MIT
// Destination of log lines: the journal when systemd reads our stderr, else stderr, in colour on a
// terminal. io and disk threads only; the real-time threads never log.
#pragma once

#include "daemon/config/config.h"

namespace hedgehog::daemon {

void start_logging(config::LogLevel level);
void set_log_level(config::LogLevel level);

}  // namespace hedgehog::daemon
