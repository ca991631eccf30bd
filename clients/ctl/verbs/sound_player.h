// SPDX-License-Identifier: MIT
// Slices of a sound as effects, sent ahead by device time.
#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "clients/ctl/verbs/session.h"
#include "clients/sound/slices.h"

namespace hedgehog::client {

/// A sound file, and the requested effect parameters, as JSON objects.
struct PlayableSound {
  sound::SliceReader reader;
  std::string params;        // of every effect
  std::string of_vibration;  // additionally, of vibrations
};

/// The parameters of effect.play for a slice, as JSON: of its pushes and of its vibration, if it
/// has them.
std::vector<std::string> effects_of(const sound::Slice& slice, const PlayableSound& sound);
/// The pushes of a slice.
std::size_t pushes_in(const sound::Slice& slice);

/// Plays one sound; `session` and `sound` must outlive it.
class SoundPlayer {
 public:
  SoundPlayer(Session& session, PlayableSound& sound, std::string name);

  /// Returns when the last effect has ended. False: interrupted.
  Outcome<bool> play();
  /// Every slice was sent in time, and all effects ended as completed.
  bool all_completed() const noexcept { return other_reason_.empty() && late_slices_ == 0; }
  /// Prints a summary, as text or as JSON.
  void print_end(bool complete) const;

 private:
  Outcome<void> begin();
  Outcome<void> read_clock();
  Outcome<void> send(const sound::Slice& slice);
  /// Waits for a notification, and processes all that were received.
  Outcome<void> follow();
  void take(const Notification& notification);
  void print_progress() const;
  std::string reason() const;
  std::string counted_pushes() const;
  std::int64_t played_ms() const;

  Session& session_;
  PlayableSound& sound_;
  std::string name_;
  std::int64_t now_ns_ = 0;  // device time, the latest received
  std::int64_t start_ns_ = 0;
  std::int64_t end_ns_ = 0;
  std::set<std::uint32_t> playing_{};
  std::size_t pushes_ = 0;
  int slices_ = 0;
  int late_slices_ = 0;
  std::string limited_by_{};
  std::string other_reason_{};
};

}  // namespace hedgehog::client
