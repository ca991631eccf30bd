// SPDX-License-Identifier: MIT
// The verbs that change the ball's state: stop (the emergency stop), arm, gain. Each returns the
// exit code.
#pragma once

#include <optional>

#include "clients/ctl/verbs/session.h"

namespace hedgehog::client {

int run_stop(Session& session);
int run_arm(Session& session);
/// Without a gain: says the one that is set.
int run_gain(Session& session, std::optional<double> gain);

}  // namespace hedgehog::client
