// SPDX-License-Identifier: MIT
// What the verbs share that go on until Ctrl-C.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "clients/common/terminal.h"
#include "clients/ctl/verbs/session.h"

namespace hedgehog::client {

/// The person's time of day, "14:03:21".
std::string time_of_day();

/// The size for a live picture: the terminal's, or 80x22 where it has fewer.
TerminalSize live_size();

/// Calls `take` with each notification until Ctrl-C, until `take` returns false, or until the
/// connection fails. `idle` is called repeatedly, whether notifications come or not. Returns the
/// exit code.
int follow(
    Session& session, const std::function<bool(const Notification&)>& take,
    const std::function<void()>& idle = [] {});

/// The same with a picture in place of the terminal: `draw` returns its lines, none when the
/// notification changes nothing. SPACE is the emergency stop, `q` leaves. A daemon that is silent,
/// or does not answer the stop, is told in the place of the first line.
int follow_drawing(Session& session,
                   const std::function<std::vector<std::string>(const Notification&)>& draw);

}  // namespace hedgehog::client
