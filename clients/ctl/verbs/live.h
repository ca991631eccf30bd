// SPDX-License-Identifier: MIT
// Shared parts of the verbs that run until Ctrl-C.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "clients/common/terminal.h"
#include "clients/ctl/verbs/session.h"

namespace hedgehog::client {

/// The local time of day, "14:03:21".
std::string time_of_day();

/// The size for a live picture: the terminal's, at least 80x22.
TerminalSize live_size();

/// Calls `take` with each notification until Ctrl-C, until `take` returns false, or until the
/// connection fails. `idle` is called repeatedly, with or without notifications. Returns the exit
/// code.
int follow(
    Session& session, const std::function<bool(const Notification&)>& take,
    const std::function<void()>& idle = [] {});

/// The same with a picture on the terminal: `draw` returns its lines, none if the notification
/// changes nothing. SPACE is the emergency stop, `q` quits. If the daemon sends nothing, or does
/// not respond to the stop, a warning replaces the first line.
int follow_drawing(Session& session,
                   const std::function<std::vector<std::string>(const Notification&)>& draw);

}  // namespace hedgehog::client
