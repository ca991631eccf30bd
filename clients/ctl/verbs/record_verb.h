// SPDX-License-Identifier: MIT
// Recording by demonstration: the path of a direction of the ball while it is turned.
#pragma once

#include <optional>
#include <string>

#include "clients/ctl/verbs/session.h"

namespace hedgehog::client {

struct RecordOptions {
  /// The pattern file to write.
  std::string file;
  bool replace = false;
  /// Of the pattern.
  std::string name = "recorded/path";
  /// The pointing direction: as typed, see direction_json.
  std::string pointer = "front";
  /// Device time; nullopt: until Ctrl-C, 60 s at most.
  std::optional<double> seconds{};
  double tolerance_deg = 2.0;
  /// Of every key frame, 0..1.
  double level = 1.0;
};

inline constexpr double kMaxRecordSeconds = 60.0;

/// Writes the path of the pointer relative to the ball's initial orientation. Ctrl-C ends the
/// recording, not the verb; a lost connection ends both, and what was recorded until then is kept.
/// File and name are checked before the recording begins.
int run_record(Session& session, const RecordOptions& options);

}  // namespace hedgehog::client
