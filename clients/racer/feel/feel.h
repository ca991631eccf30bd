// SPDX-License-Identifier: MIT
// What happens in the race, felt on the ball: the example for game developers. Everything goes
// through the public protocol, as any game's haptics would; feel.cpp says what is felt, ball_link
// who is told.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "clients/racer/feel/ball_link.h"
#include "clients/racer/feel/ball_report.h"
#include "clients/racer/feel/gain.h"
#include "clients/racer/feel/steps.h"
#include "clients/racer/game/happening.h"

namespace hedgehog::racer {

/// What was just played, or would have been without a ball.
struct Played {
  const char* kind = "";     // hit, landing, skid, tumble
  model::Vec3 direction{};   // where the pins push, in the ball's frame
  double current_a = 0.0;    // of `full_a`
  double full_a = 15.0;      // the most that the ball's limits allow
  bool on_the_ball = false;  // it was asked, and the last answer was no refusal of this game
};

/// One thread; no call waits for the daemon. Without one it does nothing and keeps looking for it.
class Feel {
 public:
  explicit Feel(std::vector<client::Address> addresses) : link_(std::move(addresses)) {}

  /// Once a frame: plays `happenings`, those of the frame that shows `time_s`, and takes what the
  /// ball says.
  void frame(const std::vector<Happening>& happenings, double time_s);
  /// Everything that plays ends: the pause menu. The next frame may play again.
  void pause();

  /// By the last frame, in the order of the happenings.
  const std::vector<Played>& played() const noexcept { return played_; }
  const BallReport& ball() const noexcept { return ball_; }
  const BallSummary& summary() const noexcept { return summary_; }
  /// Every blow has had its answer.
  bool answered() const noexcept { return blows_.empty(); }

 private:
  void listen();
  void take(const protocol::Status& status);
  void take(const protocol::Reply& answer);
  void play(const Hit& hit);
  void play(const Landing& landing);
  void play(const Skid& skid);
  void play(const Tumble& tumble);
  void play(const LapDone&) {}
  void play(const Reset&) { pause(); }
  void blow(const char* kind, const model::Vec3& direction, double impulse_n_s,
            std::int64_t duration_ms);
  /// The id of what was asked, if it was.
  std::optional<protocol::Id> play(const char* kind, const model::Vec3& direction,
                                   protocol::EffectStart effect);
  double full_a() const { return limits().current_a * gain_.now(); }
  /// Of this ball.
  const protocol::HelloLimits& limits() const { return link_.hello().limits; }
  /// The id of what was asked; nothing: there is nobody to play it.
  std::optional<protocol::Id> ask(const protocol::Request& request);

  BallLink link_;
  Gain gain_;
  PulseGate gate_;
  std::vector<protocol::Id> blows_;  // not answered yet
  std::string refused_;              // why this game may not play, by the last answer
  std::vector<Played> played_;
  BallReport ball_;
  BallSummary summary_;
  double time_s_ = 0.0;
  std::int64_t received_ns_ = 0;  // device time of the last telemetry
};

}  // namespace hedgehog::racer
