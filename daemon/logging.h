// SPDX-License-Identifier: MIT
// Log lines of the ball's events, and the destination of all lines: the journal if stderr is
// connected to it, else stderr: in colour and with the time on a terminal, with date and time in a
// file. io and disk threads only; the real-time threads never log.
#pragma once

#include "daemon/config/config.h"
#include "daemon/control/state/event.h"

namespace hedgehog::daemon {

/// `stream`, the value of JOURNAL_STREAM (nullptr: not set), identifies the file that is open as
/// `fd` (systemd.exec(5): device and inode, decimal, separated by a colon). The variable is
/// inherited by every process of a service or a desktop terminal, whose stderr may be another file.
bool is_journal(const char* stream, int fd);

void start_logging(config::LogLevel level);
void set_log_level(config::LogLevel level);

/// Logs an event of the ball other than those of effects and kStateChanged. io thread.
void log_event(const control::Event& event);

}  // namespace hedgehog::daemon
