// SPDX-License-Identifier: MIT
// What the two people see, as lines of at most 80 columns.
#pragma once

#include <string>
#include <vector>

#include "clients/study/session/desk.h"

namespace hedgehog::study {

/// Level, staircase, reversals, the ball: for the experimenter alone.
std::vector<std::string> experimenter_lines(const View& view);

/// All that the participant ever learns: never a level, whether an answer was right, or how far
/// the run has come.
struct Cue {
  Phase phase = Phase::kReady;
  int interval = 0;
  bool two_intervals = false;
  std::string question{};
  friend bool operator==(const Cue&, const Cue&) = default;
};
Cue cue_of(const View& view);
std::vector<std::string> participant_lines(const Cue& cue);

/// For a table with one screen: the same, and which key goes on when the experimenter is waited
/// for.
std::vector<std::string> blind_lines(const View& view);

/// A cue as one line for the participant's page, and back.
std::string encode(const Cue& cue);
Cue decode_cue(const std::string& line);

}  // namespace hedgehog::study
