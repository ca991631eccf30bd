// SPDX-License-Identifier: MIT
// The verbs that change the ball's state: stop (the emergency stop), arm, gain. Each returns the
// exit code.
#pragma once

#include <optional>

#include "clients/ctl/verbs/session.h"

namespace hedgehog::client {

int run_stop(Session& session);
int run_arm(Session& session);
/// Sets the gain if given; prints the gain in force.
int run_gain(Session& session, std::optional<double> gain);

}  // namespace hedgehog::client
