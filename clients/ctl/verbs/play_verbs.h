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

/// What a sound file becomes, besides the parameters of effects: see sound::SliceOptions.
struct SoundOptions {
  double low_hz = 150.0;
  double pulses = 1.0;
  double vibration = 1.0;
};

struct PlayOptions {
  /// "effect.pulse" ...
  std::string method{};
  /// As a person says it: a word, "34" (a pin), "90,20" (azimuth, elevation) or "0,1,0.5" (a
  /// vector); empty: not said.
  std::string direction{};
  /// play: the name of a pattern, or a file of one (it has a slash and ends in .json, or exists).
  std::string pattern{};
  /// Parameters under their wire names; numbers and words as typed.
  std::vector<std::pair<std::string, std::string>> params{};
  /// play: again and again.
  bool loop = false;
  /// How long it is renewed, seconds; nothing: until Ctrl-C, if it is renewed at all.
  std::optional<double> hold_s{};

  /// play: of a sound file.
  SoundOptions sound{};

  /// It has a lease, which is renewed.
  bool held() const;
};

int run_play(Session& session, const PlayOptions& options);
int run_preview(Session& session, const PlayOptions& options);

/// The `params` object of `options` as JSON text; an error when a direction or the pattern's file
/// cannot be read.
Outcome<std::string> play_params(const PlayOptions& options);

/// `options` with an end: a circle without one goes once round, in steps of `pitch_deg`. Longer
/// than an effect may last it is renewed for that time.
PlayOptions with_end(PlayOptions options, double pitch_deg = model::kThesisPitchDeg);

}  // namespace hedgehog::client
