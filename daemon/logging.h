// SPDX-License-Identifier: MIT
// Destination of log lines: the journal when it reads our stderr, else stderr: in colour and with
// the time on a terminal, with date and time in a file. io and disk threads only; the real-time
// threads never log.
#pragma once

#include "daemon/config/config.h"

namespace hedgehog::daemon {

/// `stream`, the value of JOURNAL_STREAM (nullptr: not set), names the file that is open as `fd`
/// (systemd.exec(5): device and inode, decimal, with a colon between). It is inherited by whatever
/// a service or a terminal of a desktop starts, whose stderr may be something else.
bool is_journal(const char* stream, int fd);

void start_logging(config::LogLevel level);
void set_log_level(config::LogLevel level);

}  // namespace hedgehog::daemon
