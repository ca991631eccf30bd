// SPDX-License-Identifier: MIT
// What is felt in a racing game: a lap of two seconds with a hit, a crate, a landing, a skid and a
// tumble. Exit: 0 every blow was played, 69 there is no daemon, 1 a blow was refused.
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
constexpr double kSoftestBlow = 150.0;
constexpr double kHardestBlow = 8000.0;
/// One blow in 0.25 s, unless a harder one comes.
constexpr double kApartS = 0.25;
/// What is sent every frame ends this long after the last.
constexpr int kLeaseMs = 150;

int step_of(double impulse_n_s) {
  const double share = std::log(std::max(impulse_n_s, kSoftestBlow) / kSoftestBlow) /
                       std::log(kHardestBlow / kSoftestBlow);
  return static_cast<int>(std::lround((kSteps - 1) * std::min(share, 1.0)));
}

class Haptics {
 public:
  explicit Haptics(Ball& ball) : ball_(ball) {}

  /// Once a frame, before anything else.
  void frame() {
    ball_.update();
    while (auto reply = ball_.answer()) {
      ++answered_;
      if (reply->result) continue;
      ++refused_;
      std::printf("not felt: %s\n", reply->result.error().message.c_str());
    }
  }

  /// The car was hit on that side, or landed.
  void blow(const char* what, const protocol::Direction& side, double impulse_n_s, double time_s) {
    const int step = step_of(impulse_n_s);
    if (time_s - last_s_ < kApartS && step <= last_step_) return;
    last_step_ = step;
    last_s_ = time_s;
    const auto& limits = ball_.hello().limits;
    const double current_a = limits.felt_a * std::pow(limits.current_a / limits.felt_a,
                                                      static_cast<double>(step) / (kSteps - 1));
    const protocol::EffectParams pulse{
        .direction = side, .current_a = current_a, .duration_ms = 180, .priority = 7};
    if (ball_.ask(protocol::EffectStart{model::EffectMethod::kPulse, pulse})) ++asked_;
    std::printf("%.2f s  %s: %.1f A\n", time_s, what, current_a);
  }

  /// Every frame while the wheels slide; `amount` 0 grips .. 1 no grip at all.
  void skid(double amount) {
    ball_.rumble("skid", 0.5 * amount, Word::kDown,
                 {.waveform = model::Waveform::kSquare,
                  .frequency_hz = 60.0,
                  .lease_ms = kLeaseMs,
                  .priority = 5});
  }

  /// Every frame while the car turns over; `ground`: where it is, seen from the car.
  void tumble(const protocol::Direction& ground) {
    const protocol::EffectParams hold{
        .direction = ground, .level = 0.4, .lease_ms = kLeaseMs, .slot = "tumble", .priority = 6};
    ball_.notify(protocol::EffectStart{model::EffectMethod::kHold, hold});
  }

  bool answered() const { return answered_ == asked_; }
  bool felt() const { return asked_ > 0 && refused_ == 0; }

 private:
  Ball& ball_;
  int last_step_ = -1;
  double last_s_ = -kApartS;
  int asked_ = 0;
  int answered_ = 0;
  int refused_ = 0;
};

void frame_at(Haptics& haptics, int frame) {
  const double time_s = frame / 60.0;
  if (frame == 20) haptics.blow("wall", model::Vec3{0.7, 0.7, 0.0}, 5000.0, time_s);
  if (frame == 25) haptics.blow("crate, too soon to be felt", Word::kLeft, 300.0, time_s);
  if (frame == 60) haptics.blow("landing", Word::kDown, 2500.0, time_s);
  if (frame > 70 && frame < 95) haptics.skid((frame - 70) / 25.0);
  if (frame > 95) haptics.tumble(model::Vec3{0.0, std::sin(0.2 * frame), -std::cos(0.2 * frame)});
}

}  // namespace

int main() {
  auto ball = Ball::connect({.name = "racer example"});
  if (!ball) {
    std::fprintf(stderr, "%s\n", ball.error().message.c_str());
    return 69;
  }
  Haptics haptics(*ball);
  for (int frame = 0; frame < 120 || !haptics.answered(); ++frame) {
    if (!ball->connected()) {
      std::fprintf(stderr, "%s\n", ball->problem().c_str());
      return 69;
    }
    haptics.frame();
    if (frame < 120) frame_at(haptics, frame);
    std::this_thread::sleep_for(std::chrono::milliseconds(16));
  }
  return haptics.felt() ? 0 : 1;
}
