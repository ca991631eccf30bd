// SPDX-License-Identifier: MIT
// The verbs that play: pulse, circle, vibrate, hold, play. Each stays until its effect has ended,
// because the effect ends with the connection, and returns the exit code. And preview, which says
// what any of them would do.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "clients/ctl/verbs/session.h"

namespace hedgehog::client {

struct PlayOptions {
  /// "effect.pulse" ...
  std::string method;
  /// As a person says it: a word, "34" (a pin), "90,20" (azimuth, elevation) or "0,1,0.5" (a
  /// vector); empty: not said.
  std::string direction;
  /// play: the name of a pattern, or a file of one (it has a slash and ends in .json, or exists).
  std::string pattern;
  /// Parameters under their wire names; numbers and words as typed.
  std::vector<std::pair<std::string, std::string>> params;
  /// play: again and again.
  bool loop = false;
  /// hold, and play in a loop: how long, seconds; nothing: until Ctrl-C.
  std::optional<double> hold_s;

  /// It has a lease that is renewed.
  bool held() const { return method == "effect.hold" || loop; }
};

int run_play(Session& session, const PlayOptions& options);
int run_preview(Session& session, const PlayOptions& options);

/// The `params` object of `options` as JSON text; an error when the direction or the
/// pattern's file cannot be read.
Outcome<std::string> play_params(const PlayOptions& options);

}  // namespace hedgehog::client
