// SPDX-License-Identifier: MIT
// Restores the state file at the start, with the consequences of a damaged one.
#pragma once

#include <optional>
#include <string>

#include "daemon/config/config.h"
#include "daemon/server/disk/saved_state.h"

namespace hedgehog::server {

/// The end of the sentence that reports a lost state.
inline constexpr const char* kCountsAsTripped =
    ". Latch and temperature are unknown, so the ball is treated as tripped: let it "
    "cool, then run: hedgehogctl arm";

std::string state_file(const std::string& directory);

BallIdentity ball_of(const config::Config& config);

/// The state file in `directory`; nullopt: none, a first start. If unreadable, damaged, invalid, of
/// another ball than `ball` (nullopt: any), or with an aborted first write: lost_state(), with the
/// reason in the log. The simulated ball ignores the state of a real one. Start-up only.
std::optional<SavedState> load_saved_state(const std::string& directory,
                                           const std::optional<BallIdentity>& ball = std::nullopt);

}  // namespace hedgehog::server
