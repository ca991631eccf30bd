// SPDX-License-Identifier: MIT
// Events of the race, played on the ball: the example for game developers. Uses only the public
// protocol, as any game's haptics would; feel.cpp maps events to effects, ball_link is the
// connection.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "clients/racer/feel/ball_link.h"
#include "clients/racer/feel/ball_report.h"
#include "clients/racer/feel/gain.h"
#include "clients/racer/feel/steps.h"
#include "clients/racer/game/race_event.h"

namespace hedgehog::racer {

/// An effect that was just played, or would have been with a ball.
struct Played {
  const char* kind = "";     // hit, landing, skid, tumble
  model::Vec3 direction{};   // where the pins push, in the device frame
  double current_a = 0.0;    // relative to `full_a`
  double full_a = 15.0;      // the ball's current limit
  bool on_the_ball = false;  // it was requested, and the last response was no refusal of this game
};

/// One thread; no call blocks on the daemon. Without a connection it plays nothing and keeps trying
/// to connect.
class Feel {
 public:
  explicit Feel(std::vector<client::Address> addresses) : link_(std::move(addresses)) {}

  /// Once a frame: plays `race_events`, those of the frame at `time_s`, and processes the ball's
  /// messages.
  void frame(const std::vector<RaceEvent>& race_events, double time_s);
  /// Ends all effects: for the pause menu. The next frame may play again.
  void pause();

  /// Effects of the last frame, in the order of the race events.
  const std::vector<Played>& played() const noexcept { return played_; }
  const BallReport& ball() const noexcept { return ball_; }
  const BallSummary& summary() const noexcept { return summary_; }
  /// Every blow has a response.
  bool all_answered() const noexcept { return pending_hits_.empty(); }

 private:
  void listen();
  void take(const protocol::Status& status);
  void take(const protocol::Reply& response);
  void play(const Hit& hit);
  void play(const Landing& landing);
  void play(const Skid& skid);
  void play(const Tumble& tumble);
  void play(const LapDone&) {}
  void play(const Reset&) { pause(); }
  void play_impact(const char* kind, const model::Vec3& direction, double impulse_n_s,
                   std::int64_t duration_ms);
  /// The id of the request if it was sent.
  std::optional<protocol::Id> play(const char* kind, const model::Vec3& direction,
                                   protocol::EffectStart effect);
  double full_a() const { return limits().current_a * gain_.now(); }
  /// Limits of this ball.
  const protocol::HelloLimits& limits() const { return link_.hello().limits; }
  /// The id of the request; nullopt: not connected or not armed.
  std::optional<protocol::Id> request(const protocol::Request& request);

  BallLink link_;
  Gain gain_;
  PulseGate gate_;
  std::vector<protocol::Id> pending_hits_;  // without a response so far
  std::string refused_;                     // why this game may not play, from the last response
  std::vector<Played> played_;
  BallReport ball_;
  BallSummary summary_;
  double time_s_ = 0.0;
  std::int64_t received_ns_ = 0;  // device time of the last telemetry
};

}  // namespace hedgehog::racer
