// SPDX-License-Identifier: MIT
// The playing verbs: pulse, circle, vibrate, hold, play. Each runs until its effect has ended,
// because the effect ends with the connection, and returns the exit code. And preview, which
// computes any of them without playing it.
#pragma once

#include "clients/ctl/play_options.h"
#include "clients/ctl/verbs/session.h"

namespace hedgehog::client {

int run_play(Session& session, const PlayOptions& options);
int run_preview(Session& session, const PlayOptions& options);

}  // namespace hedgehog::client
