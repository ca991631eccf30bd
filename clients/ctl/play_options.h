// SPDX-License-Identifier: MIT
// The options of the playing verbs, and the parameters of an effect from them.
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

/// Conversion of a sound file, besides the parameters of effects: see sound::SliceOptions.
struct SoundOptions {
  double low_hz = 150.0;
  double pulses = 1.0;
  double vibration = 1.0;
};

struct PlayOptions {
  /// "effect.pulse" ...
  std::string method{};
  /// As typed: a word, "34" (a pin), "90,20" (azimuth, elevation) or "0,1,0.5" (a vector); empty:
  /// not given.
  std::string direction{};
  /// play: the name of a pattern, or a file: see is_pattern_file.
  std::string pattern{};
  /// The content of that file; see with_file.
  std::optional<protocol::Pattern> file_pattern{};
  /// Parameters under their wire names; numbers and words as typed.
  std::vector<std::pair<std::string, std::string>> params{};
  /// play: repeats it.
  bool loop = false;
  /// Duration of the renewals, seconds; nullopt: until Ctrl-C, if it has a lease.
  std::optional<double> hold_s{};

  /// play: of a sound file.
  SoundOptions sound{};

  /// It has a lease, which is renewed.
  bool held() const;
};

/// `options` with the content of the pattern file, and a sentence for each thing that was left out;
/// without a file unchanged. A pattern that exceeds the maximum duration of an effect, and has no
/// other end, is renewed for its duration. Errors as of read_any_pattern; kBadData for a file
/// without the extension of a pattern.
struct WithFile {
  PlayOptions options;
  std::vector<std::string> notes;
};
Outcome<WithFile> with_file(PlayOptions options);

/// The `params` object of `options` as JSON text; an error if a direction is invalid. A file must
/// have been read by with_file.
Outcome<std::string> play_params(const PlayOptions& options);

/// `options` with an end: a circle without one goes round once, in steps of `pitch_deg`. If it
/// exceeds the maximum duration of an effect it is renewed for that time.
PlayOptions with_end(PlayOptions options, double pitch_deg = model::kThesisPitchDeg);

}  // namespace hedgehog::client
