// SPDX-License-Identifier: MIT
// The verbs that play: pulse, circle, vibrate, hold, play. Each stays until its effect has ended,
// because the effect ends with the connection, and returns the exit code. And preview, which says
// what any of them would do.
#pragma once

#include "clients/ctl/play_options.h"
#include "clients/ctl/verbs/session.h"

namespace hedgehog::client {

int run_play(Session& session, const PlayOptions& options);
int run_preview(Session& session, const PlayOptions& options);

}  // namespace hedgehog::client
