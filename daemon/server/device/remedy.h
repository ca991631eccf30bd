// SPDX-License-Identifier: MIT
// Remedy of a state: one sentence with the command to type. The only place with these sentences.
#pragma once

#include <optional>
#include <string>

#include "daemon/control/state/state.h"
#include "model/limit/limits.h"

namespace hedgehog::server {

struct RemedyFacts {
  /// Below this temperature a ball that overheated can be armed again.
  double rearm_c = 45.0;
  bool simulated = false;
  /// Reason for which a connected board is not used; empty: none connected, or in use.
  std::string board_problem{};
  /// Seconds until a tripped ball may be armed again, and how often it was after the same trip.
  double rearm_wait_s = 0.0;
  int rearms = 0;
  /// The last trip names measurements that contradict each other.
  bool contradicted = false;
};

/// nullopt: no problem.
std::optional<std::string> remedy(control::State state, control::Reason reason,
                                  const RemedyFacts& facts);

/// For an armed ball whose thermal limit is too low to be felt: the upper bounds of its hottest
/// winding, `hottest_c`, and of its shell, `skin_c`.
std::string too_hot_remedy(double hottest_c, double skin_c, const model::Limits& limits);

/// The wire name of `reason`; nullopt for kNone (null on the wire).
std::optional<std::string> reason_name(control::Reason reason);

}  // namespace hedgehog::server
