// SPDX-License-Identifier: MIT
// Text and JSON of the events of the race.
#pragma once

#include <string>
#include <vector>

#include "clients/racer/game/race_event.h"

namespace hedgehog::racer {

/// One JSON object: {"time_s":12.5,"type":"hit","direction":[0.64,-0.77,0],"impulse_n_s":3403.2}.
/// Types: hit, landing, skid {amount}, tumble {down}, lap {lap, lap_time_s}, reset.
std::string to_json(const RaceEvent& race_event, double time_s);

/// Lines for users; lasting events are printed once, at their end.
class RaceEventLog {
 public:
  /// The lines of one step; call it for each step, with or without happenings.
  std::vector<std::string> lines(const std::vector<RaceEvent>& race_events, double time_s);

 private:
  struct Lasting {
    double since_s = -1.0;
    double max_amount = 0.0;
  };
  static std::string ended(const char* what, const Lasting& lasting, double time_s);

  Lasting skid_;
  Lasting tumble_;
};

/// "front left", "back", "roof": one of eight sides, or up or down if that dominates.
std::string side_of(const model::Vec3& direction);

}  // namespace hedgehog::racer
