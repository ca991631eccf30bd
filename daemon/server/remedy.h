// SPDX-License-Identifier: MIT
// What a person can do about the state of the ball: one sentence with the command to type. The only
// place where these sentences stand.
#pragma once

#include <optional>
#include <string>

#include "daemon/control/state.h"

namespace hedgehog::server {

struct RemedyFacts {
  /// Below this temperature a ball that overheated can be armed again.
  double rearm_c = 45.0;
  bool simulated = false;
  /// Why a board that is connected is not used; empty: none is, or it is used.
  std::string board_trouble{};
};

/// nullopt: nothing is wrong.
std::optional<std::string> remedy(control::State state, control::Reason reason,
                                  const RemedyFacts& facts);

/// The wire name of `reason`; nullopt for kNone (null on the wire).
std::optional<std::string> reason_name(control::Reason reason);

}  // namespace hedgehog::server
