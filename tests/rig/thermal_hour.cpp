// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <vector>

#include "daemon/control/fan.h"
#include "daemon/control/heat_check.h"
#include "daemon/control/sensor_check.h"
#include "model/thermal_limiter.h"
#include "model/thermal_observer.h"
#include "tests/rig/hours.h"
#include "tests/rig/random_requests.h"

namespace hedgehog::rig {
namespace {

using control::Reason;
using model::Vec3;

constexpr double kStepS = 0.02;

struct Player {
  Temper temper;
  double until_s = 0.0;  // of the effect, or of the pause
  bool playing = false;
  Vec3 peak_a;
  double rms = 1.0;
};

/// The three layers as far as heat goes, in steps of 20 ms.
class ThermalBall {
 public:
  explicit ThermalBall(const device::SimulatedBoardOptions& board) noexcept
      : plant_(board.plant, board.ambient_c),
        observer_(coils_, model::ThermalModel{}, start_of(board)) {
    observer_.trust_start({true, true, true});
  }

  /// The reason of a trip, or kNone. `peak` is scaled by the limiter, its mean square is `rms`^2 of
  /// that.
  Reason step(const Vec3& peak, double rms) noexcept {
    const model::LimitedCurrents passed = limiter_.limit({peak}, observer_.estimate(), kStepS);
    const Vec3 mean_a = rms * passed.a();
    model::ThermalMeasurement m;
    Vec3 squares;
    for (int coil = 0; coil < model::kCoils; ++coil) {
      const double measured = std::round(1000.0 * mean_a[coil]) * 1e-3;  // the board counts mA
      m.voltage_v[coil] = plant_.resistance_ohm(coil) * mean_a[coil];
      m.current_a[coil] = measured;
      squares[coil] = mean_a[coil] * mean_a[coil];
    }
    m.current_before_a = m.current_a;
    m.electrical_valid = norm(mean_a) > 0.0;
    plant_.step_thermal(squares, fan_duty_, kStepS);
    m.sensor_c = plant_.sensor_c();
    m.fan_running = plant_.fan_rpm() > 300.0;

    const int own = plant_.parameters().sensor_winding;
    const Reason sensor = sensor_.step({true, false, false, m.sensor_c, ++conversions_,
                                        heat_.measuring(own), heat_.winding_c(own), kStepS},
                                       kStepS);
    const Reason heat = heat_.step({m.electrical_valid, m.voltage_v, m.current_before_a,
                                    m.current_a, true, m.sensor_c, true, kStepS},
                                   model::Limits{}.trip_c, kStepS);
    m.sensor_valid = sensor_.usable();
    observer_.step(m, kStepS);
    fan_duty_ = fan_.step(observer_.estimate().hottest_c, norm(mean_a), kStepS) / 255.0;
    reduced_ = norm(passed.a()) < 0.995 * std::min(norm(peak), model::Limits{}.current_a);
    return sensor != Reason::kNone ? sensor : heat;
  }

  const model::Plant& plant() const noexcept { return plant_; }
  bool reduced() const noexcept { return reduced_; }

 private:
  static model::ThermalState start_of(const device::SimulatedBoardOptions& board) noexcept {
    const double t = board.start_c;
    return {{t, t, t}, t};
  }

  model::CoilModel coils_;
  model::Plant plant_;
  model::ThermalObserver observer_;
  model::ThermalLimiter limiter_{model::Limits{}};
  control::SensorCheck sensor_;
  control::HeatCheck heat_{coils_};
  control::Fan fan_;
  double fan_duty_ = 0.0;
  std::uint8_t conversions_ = 0;
  bool reduced_ = false;
};

}  // namespace

HourResult thermal_hour(std::uint64_t seed, double seconds) {
  model::RandomStream random(seed);
  ThermalBall ball(random_board(random));
  std::vector<Player> players(1 + random.bits() % 4);
  for (Player& player : players) player.temper = Temper::draw(random);

  HourResult result;
  std::uint64_t reduced = 0;
  const auto steps = static_cast<std::uint64_t>(seconds / kStepS);
  for (std::uint64_t i = 0; i < steps; ++i) {
    const double now = static_cast<double>(i) * kStepS;
    Vec3 peak;
    double rms = 0.0;
    for (Player& player : players) {
      if (now >= player.until_s) {
        player.playing = !player.playing;
        if (player.playing) {
          const model::EffectSpec spec = random_effect(random, player.temper);
          player.peak_a = spec.strength_a * spec.trajectory.direction;
          player.rms = rms_fraction(spec);
          player.until_s = now + 1e-3 * static_cast<double>(spec.duration + spec.lease);
          ++result.effects;
        } else {
          player.until_s = now + exponential(random, player.temper.mean_pause_s);
        }
      }
      if (!player.playing) continue;
      peak = peak + player.peak_a;
      rms = std::max(rms, player.rms);
    }
    const Reason reason = ball.step(peak, rms);
    if (ball.reduced()) ++reduced;
    result.hottest_c = std::max(result.hottest_c, ball.plant().hottest_winding_c());
    if (reason != Reason::kNone) {
      result.failure = "tripped: " + std::string(name(reason)) + " at " + std::to_string(now) +
                       " s, hottest " + std::to_string(result.hottest_c) + " C";
      break;
    }
  }
  if (result.failure.empty() && result.hottest_c > kHottestAllowedC) {
    result.failure = "a winding reached " + std::to_string(result.hottest_c) + " C";
  }
  result.derated = static_cast<double>(reduced) / static_cast<double>(steps);
  return result;
}

}  // namespace hedgehog::rig
