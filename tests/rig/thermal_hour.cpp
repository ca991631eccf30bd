// SPDX-License-Identifier: MIT
#include <algorithm>

#include "tests/rig/calibrated_ball.h"
#include "tests/rig/hours.h"
#include "tests/rig/random_play.h"
#include "tests/rig/thermal_ball.h"

namespace hedgehog::rig {

std::string follow_skin(HourResult& result, double skin_c, double now_s) {
  const bool held = now_s > kHeldAfterS;
  result.skin_c = std::max(result.skin_c, skin_c);
  if (held) result.held_skin_c = std::max(result.held_skin_c, skin_c);
  if (skin_c <= (held ? kHeldSkinAllowedC : kSkinAllowedC)) return {};
  return "the skin reached " + std::to_string(skin_c) + " C at " + std::to_string(now_s) + " s";
}

namespace {

HourResult play(ThermalBallOptions options, std::uint64_t seed, double seconds, double hand) {
  options.skin_limits = true;
  options.board.plant.core_to_ambient_fan_k_w *= hand;
  options.board.plant.core_to_ambient_still_k_w *= hand;
  ThermalBall ball(options);
  RandomPlay play(~seed);

  HourResult result;
  std::uint64_t reduced = 0;
  std::uint64_t steps = 0;
  while (static_cast<double>(steps) * ThermalBall::kStepS < seconds && !ball.stop().any()) {
    const RandomPlay::RequestedCurrents requested =
        play.at(static_cast<double>(steps) * ThermalBall::kStepS);
    ball.step(requested.peak_a, requested.rms);
    if (ball.reduced()) ++reduced;
    result.hottest_c = std::max(result.hottest_c, ball.plant().hottest_winding_c());
    ++steps;
    result.failure = follow_skin(result, ball.plant().skin_c(),
                                 static_cast<double>(steps) * ThermalBall::kStepS);
    if (!result.failure.empty()) break;
  }
  result.effects = play.effects();
  result.seconds = static_cast<double>(steps) * ThermalBall::kStepS;
  if (ball.stop().any()) {
    result.failure = "tripped: " + words(ball.stop()) + " at " + std::to_string(result.seconds) +
                     " s, hottest " + std::to_string(result.hottest_c) + " C";
  } else if (result.hottest_c > kHottestAllowedC) {
    result.failure = "a winding reached " + std::to_string(result.hottest_c) + " C";
  }
  result.derated = static_cast<double>(reduced) / static_cast<double>(steps);
  return result;
}

}  // namespace

HourResult thermal_hour(std::uint64_t seed, double seconds, const device::FrontEndChoice& front_end,
                        double thermal_tolerance, double hand) {
  return play(family_ball(seed, front_end, thermal_tolerance), seed, seconds, hand);
}

HourResult calibrated_hour(std::uint64_t seed, double seconds,
                           const device::FrontEndChoice& front_end) {
  constexpr double kTolerance = 0.2;
  const auto ball = calibrated(family_ball(seed, front_end, kTolerance));
  if (ball) return play(*ball, seed, seconds, 1.0);
  HourResult refused;
  refused.failure = "its heating did not fit";
  return refused;
}

}  // namespace hedgehog::rig
