// SPDX-License-Identifier: MIT
// The options of the verbs that play, and the parameters of an effect from them.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "clients/lib/client_error.h"
#include "model/geometry/pin_array.h"
#include "protocol/values/pattern.h"

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
  /// vector); empty: not given.
  std::string direction{};
  /// play: the name of a pattern, or a file: see is_pattern_file.
  std::string pattern{};
  /// What that file has; see with_file.
  std::optional<protocol::Pattern> file_pattern{};
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

/// `options` with what the file of a pattern has, and a sentence for each thing that was left out
/// of it; no file: unchanged. One that takes longer than an effect may last, and has no other end,
/// is renewed for that time. The errors are those of read_any_pattern; and kBadData for a file that
/// is no pattern's by how its name ends.
struct WithFile {
  PlayOptions options;
  std::vector<std::string> notes;
};
Outcome<WithFile> with_file(PlayOptions options);

/// The `params` object of `options` as JSON text; an error when a direction cannot be read. A file
/// is what with_file made of it.
Outcome<std::string> play_params(const PlayOptions& options);

/// `options` with an end: a circle without one goes once round, in steps of `pitch_deg`. Longer
/// than an effect may last it is renewed for that time.
PlayOptions with_end(PlayOptions options, double pitch_deg = model::kThesisPitchDeg);

}  // namespace hedgehog::client
