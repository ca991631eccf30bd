// SPDX-License-Identifier: MIT
// Sound files played and previewed: slices of half a second, sent two seconds ahead by device time.
#pragma once

#include "clients/ctl/verbs/play_verbs.h"

namespace hedgehog::client {

/// It ends as sound files do (.wav, .flac, .ogg, .aiff, .mp3); and "acme/x.wav", which may be a
/// vendor's pattern too, only where there is that file.
bool is_sound_file(const std::string& text);

/// Plays `options.pattern`, a sound file, to its end or until Ctrl-C. Nothing plays on for more
/// than two seconds when this program is stopped, and nothing at all when it ends.
int run_sound(Session& session, const PlayOptions& options);
/// What run_sound would send; as JSON the parameters of each effect.play, a line each, with
/// `at_ms`.
int run_sound_preview(Session& session, const PlayOptions& options);

}  // namespace hedgehog::client
