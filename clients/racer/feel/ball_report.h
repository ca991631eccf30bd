// SPDX-License-Identifier: MIT
// The ball's status for display during the game, and a summary for its end.
#pragma once

#include <optional>
#include <string>

#include "model/quaternion.h"

namespace hedgehog::racer {

struct BallReport {
  bool connected = false;
  bool simulated = false;
  /// Why nothing is felt, one sentence: not connected, or requests of this game are refused; empty
  /// while the first attempt to connect is in progress.
  std::string problem{};
  /// `connected` is false, but a daemon exists: it is silent, or its response timed out.
  bool late = false;
  std::string state{};    // armed, disarmed, tripped, absent; empty: no daemon
  std::string remedy{};   // instruction for the user; empty: none
  double gain = 1.0;      // the game's own, 1 = full strength
  bool derating = false;  // the daemon reduces what the game plays
  double limit_a = 0.0;   // the daemon's present current limit
  std::optional<double> temperature_c{};
  /// Remaining burst time at full strength; nullopt: unlimited.
  std::optional<double> burst_s{};
  /// Orientation of the ball, for driving by tilt; nullopt: unknown.
  std::optional<model::Quaternion> orientation{};
};

/// "the ball is armed", "the ball is tripped: let it cool", "another client has the ball for
/// itself"; empty while the first attempt to connect is in progress.
inline std::string sentence(const BallReport& ball) {
  if (!ball.problem.empty() || !ball.connected) return ball.problem;
  return "the ball is " + ball.state + (ball.remedy.empty() ? "" : ": " + ball.remedy);
}

/// Statistics of the effects, for the end of the race.
struct BallSummary {
  int pulses = 0;            // hits and landings that the daemon accepted
  int refused = 0;           // refused, never answered, or not sent without connection
  int left_out = 0;          // hits too soon after a stronger or equal one
  double turned_down_s = 0;  // the game's own gain was below 1; device time
  double min_gain = 1.0;
  double derated_s = 0;  // the daemon reduced what was played; device time
  std::optional<double> min_limit_a{};
  std::optional<double> hottest_c{};
  bool tripped = false;
};

}  // namespace hedgehog::racer
