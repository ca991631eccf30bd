// SPDX-License-Identifier: MIT
// `hedgehogctl latency`: how long effects took from their request to the board.
#pragma once

#include <string>
#include <vector>

#include "clients/ctl/verbs/session.h"
#include "protocol/methods/effect.h"

namespace hedgehog::client {

/// Returns the exit code.
int run_latency(Session& session);
/// The lines of its output.
std::vector<std::string> latency_lines(const protocol::LatencyResult& latency);

}  // namespace hedgehog::client
