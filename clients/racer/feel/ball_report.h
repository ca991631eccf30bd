// SPDX-License-Identifier: MIT
// The ball as a game shows it, while it plays and at its end.
#pragma once

#include <optional>
#include <string>

#include "model/quaternion.h"

namespace hedgehog::racer {

struct BallReport {
  bool connected = false;
  bool simulated = false;
  /// Why nothing is felt, one sentence: not connected, or connected and refused to this game; empty
  /// while the daemon is still being looked for.
  std::string trouble{};
  /// Not connected, but a daemon is there: it is silent, or its response timed out.
  bool late = false;
  std::string state{};    // armed, disarmed, tripped, absent; empty: no daemon
  std::string remedy{};   // what to do about it; empty: nothing
  double gain = 1.0;      // the game's own, 1 = as strong as it may be
  bool derating = false;  // the daemon reduces what the game plays
  double limit_a = 0.0;   // the most that the daemon allows now
  std::optional<double> temperature_c{};
  /// How long full strength could last from now; nothing: for ever.
  std::optional<double> burst_s{};
  /// How the ball is held, for driving by tilt; nothing: not known.
  std::optional<model::Quaternion> orientation{};
};

/// "the ball is armed", "the ball is tripped: let it cool", "another client has the ball for
/// itself"; empty while the daemon is still being looked for.
inline std::string sentence(const BallReport& ball) {
  if (!ball.trouble.empty() || !ball.connected) return ball.trouble;
  return "the ball is " + ball.state + (ball.remedy.empty() ? "" : ": " + ball.remedy);
}

/// What was felt and what was not, for the end of the race.
struct BallSummary {
  int pulses = 0;            // hits and landings that the daemon took
  int refused = 0;           // that it refused, never answered, or was not there to be asked
  int left_out = 0;          // hits too soon after a stronger or equal one
  double turned_down_s = 0;  // the game's own gain was below 1; device time
  double min_gain = 1.0;
  double derated_s = 0;  // the daemon reduced what was played; device time
  std::optional<double> min_limit_a{};
  std::optional<double> hottest_c{};
  bool tripped = false;
};

}  // namespace hedgehog::racer
