// SPDX-License-Identifier: MIT
// Remedy of a state: one sentence with the command to type. The only place with these sentences.
#pragma once

#include <optional>
#include <string>

#include "daemon/control/state/state.h"
#include "model/limit/limits.h"

namespace hedgehog::server {

struct RemedyFacts {
  double rearm_c = 45.0;  // below it a ball that overheated can be armed again
  bool simulated = false;
  std::string board_problem{};  // of a connected board that is not used; empty: none
  double rearm_wait_s = 0.0;    // until a tripped ball may be armed again
  int rearms = 0;               // after the same trip
  bool contradicted = false;    // the last trip names measurements that contradict each other
};

/// nullopt: no problem.
std::optional<std::string> remedy(control::State state, control::Reason reason,
                                  const RemedyFacts& facts);

/// Armed, but the thermal limit is too low to be felt: upper bounds of hottest winding and shell.
std::string too_hot_remedy(double hottest_c, double skin_c, const model::Limits& limits);

/// The wire name of `reason`; nullopt for kNone (null on the wire).
std::optional<std::string> reason_name(control::Reason reason);

}  // namespace hedgehog::server
