// SPDX-License-Identifier: MIT
// Sound files played and previewed: slices of half a second, sent two seconds ahead by device time.
#pragma once

#include "clients/ctl/verbs/play_verbs.h"

namespace hedgehog::client {

/// True for the extension of a sound file (.wav, .flac, .ogg, .aiff, .mp3); for "acme/x.wav", which
/// may also be a vendor's pattern, only if that file exists.
bool is_sound_file(const std::string& text);

/// Plays `options.pattern`, a sound file, to its end or until Ctrl-C. Playback ends within two
/// seconds when this program is stopped, and at once when it ends.
int run_sound(Session& session, const PlayOptions& options);
/// Prints what run_sound would send; as JSON the parameters of each effect.play, a line each, with
/// `at_ms`.
int run_sound_preview(Session& session, const PlayOptions& options);

}  // namespace hedgehog::client
