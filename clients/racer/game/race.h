// SPDX-License-Identifier: MIT
// The race: a car on a track, step by step. The same controls result in the same scenes and
// happenings bit for bit, in every run of one build.
#pragma once

#include <memory>
#include <vector>

#include "clients/racer/game/race_event.h"
#include "clients/racer/game/scene.h"
#include "clients/racer/game/track.h"

namespace hedgehog::racer {

/// One thread at a time; independent of the system clock.
class Race {
 public:
  /// Duration of one step: a frame of a 60 Hz screen.
  static constexpr double kStepS = 1.0 / 60.0;

  explicit Race(Track track);
  Race(Race&&) noexcept;
  Race& operator=(Race&&) noexcept;
  ~Race();

  /// Advances by kStepS. Controls out of range are clamped.
  const Scene& step(const Controls& controls);
  const Scene& scene() const noexcept;
  /// Of the last step.
  const std::vector<RaceEvent>& race_events() const noexcept;
  const Track& track() const noexcept;

  /// Puts the car on its wheels in the middle of the road, at rest, before any obstacle. Reports
  /// `Reset` with the next step. A car that lies on its roof for 3 s is recovered automatically.
  void recover();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace hedgehog::racer
