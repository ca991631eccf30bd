// SPDX-License-Identifier: MIT
// What is felt in a racing game: a lap of three seconds with two gear changes, a skid, a hit, a
// crate and a landing. Exit: 0 all of it was played, 69 there is no daemon, 1 a pulse was refused.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <thread>
#include <utility>

#include "clients/lib/ball.h"

using namespace hedgehog;
using protocol::Word;

namespace {

/// Eight steps from what is just felt to full strength are 32 % apart; people notice 13 % (thesis,
/// experiment 2).
constexpr int kSteps = 8;
/// Blows of these impulses are the first and the last step; Newton seconds.
constexpr double kMinHitImpulse = 150.0;
constexpr double kMaxHitImpulse = 8000.0;
/// One blow in 0.25 s, unless a harder one comes.
constexpr double kApartS = 0.25;
/// Of two effects only the one of higher priority is felt; of the same, both.
constexpr int kEngine = 3;
constexpr int kGear = 4;
constexpr int kSkid = 5;
constexpr int kImpactPriority = 7;
constexpr int kFrames = 180;
constexpr double kRateHz = 60.0;

int step_of(double impulse_n_s) {
  const double share = std::log(std::max(impulse_n_s, kMinHitImpulse) / kMinHitImpulse) /
                       std::log(kMaxHitImpulse / kMinHitImpulse);
  return static_cast<int>(std::lround((kSteps - 1) * std::min(share, 1.0)));
}

/// Nothing here waits for a response.
class CarFeel {
 public:
  explicit CarFeel(Ball& ball) : ball_(ball) {}

  /// Once a frame, before anything else.
  void frame() {
    ball_.update();
    while (auto reply = ball_.response()) {
      ++responses_;
      if (reply->result) continue;
      ++refused_;
      std::printf("not felt: %s\n", reply->result.error().message.c_str());
    }
  }

  /// Every frame, 0..1 each. False: there is no daemon.
  bool engine(double revolutions, double throttle) {
    return ball_.rumble("engine", 0.05 + 0.25 * throttle, Word::kBack,
                        {.frequency_hz = 30.0 + 60.0 * revolutions, .priority = kEngine});
  }

  /// Every frame while the wheels slide; 0 they grip .. 1 not at all. It lasts, so it is weaker
  /// than a blow can be.
  void skid(double amount) {
    ball_.rumble("skid", 0.5 * amount, Word::kDown,
                 {.waveform = model::Waveform::kSquare, .frequency_hz = 60.0, .priority = kSkid});
  }

  /// The clutch has closed: a knock from behind.
  void gear() { pulse(Word::kBack, 1, 40, kGear); }

  /// The car was hit on that side, or landed; its step, or -1 when it is too soon to be felt.
  int impact(const protocol::Direction& side, double impulse_n_s, double time_s) {
    const int step = step_of(impulse_n_s);
    if (time_s - last_s_ < kApartS && step <= last_step_) return -1;
    last_step_ = step;
    last_s_ = time_s;
    pulse(side, step, 180, kImpactPriority);
    return step;
  }

  bool all_answered() const { return responses_ == sent_; }
  bool felt() const { return sent_ > 0 && refused_ == 0; }

 private:
  void pulse(const protocol::Direction& side, int step, int duration_ms, int priority) {
    const auto& limits = ball_.hello().limits;
    const double current_a = limits.felt_a * std::pow(limits.current_a / limits.felt_a,
                                                      static_cast<double>(step) / (kSteps - 1));
    const protocol::EffectParams pulse{.direction = side,
                                       .current_a = current_a,
                                       .duration_ms = duration_ms,
                                       .priority = priority};
    if (ball_.request(protocol::EffectStart{model::EffectMethod::kPulse, pulse})) ++sent_;
  }

  Ball& ball_;
  int last_step_ = -1;
  double last_s_ = -kApartS;
  int sent_ = 0;
  int responses_ = 0;
  int refused_ = 0;
};

void play_frame(CarFeel& feel, int frame) {
  const double time_s = frame / kRateHz;
  const auto impact = [&](const char* what, const protocol::Direction& side, double impulse_n_s) {
    std::printf("%.2f s  %s: step %d\n", time_s, what, feel.impact(side, impulse_n_s, time_s));
  };
  if (frame == 30 || frame == 60) {
    feel.gear();
    std::printf("%.2f s  gear\n", time_s);
  }
  if (frame > 60 && frame < 90) feel.skid((frame - 60) / 30.0);
  if (frame == 100) impact("wall", model::Vec3{0.7, -0.7, 0.0}, 5000.0);
  if (frame == 105) impact("crate", Word::kLeft, 300.0);
  if (frame == 150) impact("landing", Word::kDown, 2500.0);
  feel.engine((frame % 60) / 60.0, 1.0);
}

}  // namespace

int main() {
  auto ball = Ball::connect({.name = "racer example"});
  if (!ball) {
    std::fprintf(stderr, "%s\n", ball.error().message.c_str());
    return 69;
  }
  CarFeel feel(*ball);
  for (int frame = 0; frame < kFrames || !feel.all_answered(); ++frame) {
    feel.frame();
    if (frame < kFrames) play_frame(feel, frame);
    if (!ball->connected()) {
      std::fprintf(stderr, "%s\n", ball->problem().c_str());
      return 69;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(16));
  }
  return feel.felt() ? 0 : 1;
}
