// SPDX-License-Identifier: MIT
// Screens of the experimenter and the participant, as lines of at most 80 columns.
#pragma once

#include <string>
#include <vector>

#include "clients/study/session/desk.h"

namespace hedgehog::study {

/// Level, staircase, reversals, the ball: for the experimenter only.
std::vector<std::string> experimenter_lines(const View& view);

/// All information for the participant: never a level, whether a response was correct, or the
/// progress of the run.
struct Cue {
  Phase phase = Phase::kReady;
  int interval = 0;
  bool two_intervals = false;
  std::string question{};
  friend bool operator==(const Cue&, const Cue&) = default;
};
Cue cue_of(const View& view);
std::vector<std::string> participant_lines(const Cue& cue);

/// For a setup with one screen: the same, and the key to continue while waiting for the
/// experimenter.
std::vector<std::string> blind_lines(const View& view);

/// Encodes a cue as one line for the participant's page, and decodes it.
std::string encode(const Cue& cue);
Cue decode_cue(const std::string& line);

}  // namespace hedgehog::study
