// SPDX-License-Identifier: MIT
#include "model/forecast.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace hedgehog::model {
namespace {

constexpr double kHorizonS = 4.0 * 3600.0;
// Slower than this nothing will be crossed any more: what is still to come is this times the time
// constant of the whole ball, 0.05 K with its fan and 0.13 K without.
constexpr double kSettledK_s = 1e-4;
// A winding that carries less is not measured by its own resistance (see WindingMeter).
constexpr double kMeasuredA = 1.5;

// A step is as long as the nodes stay within this (crossings are interpolated linearly) and the
// integration is stable and exact to a hundredth of a kelvin, but at least a tick.
constexpr double kStepK = 0.5;
constexpr double kShortestS = 1e-3;
constexpr double kLongestWhileFanIsOpenS = 2.0;
// A device file may describe a ball so light that this ends before the horizon; an ordinary one
// needs a third of it.
constexpr int kMaxForecastSteps = 4000;

/// The ball under a constant load, with its fan.
class Course {
 public:
  Course(const CoilModel& coils, const ThermalModel& thermal, const ForecastStart& start,
         const Vec3& rms_a) noexcept
      : coils_(coils), thermal_(thermal), nodes_(start.nodes), mean_a_(start.mean_current_a) {
    load_.room_c = start.room_c;
    load_.fan_running = start.fan_running && start.fan_works;
    fan_works_ = start.fan_works;
    norm_a_ = norm(rms_a);
    for (int coil = 0; coil < kCoils; ++coil) {
      const auto i = static_cast<std::size_t>(coil);
      squares_a2_[i] = rms_a[coil] * rms_a[coil];
      load_.guessed[i] = std::abs(rms_a[coil]) < kMeasuredA;
    }
    // Gershgorin: no eigenvalue of the four nodes is beyond twice the diagonal of its row.
    const double to_room_k_w =
        std::min(thermal.core_to_room_fan_k_w, thermal.core_to_room_still_k_w);
    const double core =
        (2.0 * kCoils / thermal.winding_to_core_k_w + 1.0 / to_room_k_w) / thermal.core_j_k;
    const double winding = 2.0 / (thermal.winding_to_core_k_w * thermal.winding_j_k);
    longest_s_ = 1.0 / std::max(core, winding);
  }

  /// One step; false once nothing moves any more or the horizon is reached.
  bool step() noexcept {
    run_fan();
    const ThermalState k1 = rates(nodes_);
    const bool mean_settled = std::abs(norm_a_ - mean_a_) < 0.01;
    const double fastest = steepest(k1);
    if (fastest <= kSettledK_s && mean_settled) return false;
    double dt_s = mean_settled ? longest_s_ : std::min(longest_s_, kLongestWhileFanIsOpenS);
    dt_s = std::max(kShortestS, std::min(dt_s, kStepK / fastest));
    const ThermalState k2 = rates(advanced(nodes_, k1, 0.5 * dt_s));
    const ThermalState k3 = rates(advanced(nodes_, k2, 0.5 * dt_s));
    const ThermalState k4 = rates(advanced(nodes_, k3, dt_s));
    for (std::size_t i = 0; i < kCoils; ++i)
      nodes_.winding_c[i] +=
          dt_s / 6.0 *
          (k1.winding_c[i] + 2.0 * (k2.winding_c[i] + k3.winding_c[i]) + k4.winding_c[i]);
    nodes_.core_c += dt_s / 6.0 * (k1.core_c + 2.0 * (k2.core_c + k3.core_c) + k4.core_c);
    time_s_ += dt_s;
    mean_a_ += (norm_a_ - mean_a_) * (1.0 - std::exp(-dt_s / kFanMeanS));
    return time_s_ < kHorizonS && ++steps_ < kMaxForecastSteps;
  }

  double hottest_c() const noexcept { return hottest_winding(nodes_); }
  double time_s() const noexcept { return time_s_; }

 private:
  static double steepest(const ThermalState& rate) noexcept {
    double fastest = std::abs(rate.core_c);
    for (const double r : rate.winding_c) fastest = std::max(fastest, std::abs(r));
    return fastest;
  }

  void run_fan() noexcept {
    const double hottest = hottest_c();
    if (hottest > kFanOnC || mean_a_ > kFanOnA) load_.fan_running = fan_works_;
    if (hottest < kFanOffC && mean_a_ <= kFanOnA) load_.fan_running = false;
  }

  ThermalState rates(const ThermalState& nodes) noexcept {
    for (std::size_t i = 0; i < kCoils; ++i)
      load_.loss_w[i] = squares_a2_[i] *
                        resistance_at(Ohms(coils_.r25_ohm[i]), Celsius(nodes.winding_c[i])).value;
    return heating_rates(thermal_, nodes, load_);
  }

  const CoilModel& coils_;
  const ThermalModel& thermal_;
  ThermalState nodes_;
  HeatLoad load_;
  std::array<double, kCoils> squares_a2_{};
  double norm_a_ = 0.0;
  double mean_a_ = 0.0;
  double time_s_ = 0.0;
  double longest_s_ = 1.0;
  int steps_ = 0;
  bool fan_works_ = true;
};

/// A temperature that is awaited on a course.
struct Crossing {
  double goal_c = 0.0;
  bool rising = true;
  std::optional<double> at_s{};

  bool reached(double t) const noexcept { return rising ? t >= goal_c : t <= goal_c; }
};

/// When the hottest winding first is at each of `crossings`; runs until the last of them.
void await(Course course, std::span<Crossing> crossings) noexcept {
  double before_c = course.hottest_c();
  bool open = false;
  for (Crossing& c : crossings) {
    if (c.reached(before_c)) c.at_s = 0.0;
    open = open || !c.at_s;
  }
  for (bool more = true; more && open;) {
    const double before_s = course.time_s();
    more = course.step();
    const double now_c = course.hottest_c();
    open = false;
    for (Crossing& c : crossings) {
      if (c.at_s) continue;
      if (!std::isfinite(now_c)) {
        if (c.rising) c.at_s = before_s;
        continue;
      }
      if (c.reached(now_c)) {
        const double share = (c.goal_c - before_c) / (now_c - before_c);
        c.at_s = before_s + share * (course.time_s() - before_s);
      } else {
        open = true;
      }
    }
    before_c = now_c;
  }
}

std::optional<double> time_to(const Course& course, double goal_c, bool rising) noexcept {
  Crossing crossing{goal_c, rising};
  await(course, {&crossing, 1});
  return crossing.at_s;
}

/// The hottest winding when all has settled with `rms_a`, by the fixed point in closed form;
/// infinity when the copper runs away.
double settled_c(const CoilModel& coils, const ThermalModel& thermal, double room_c,
                 double to_room_k_w, const Vec3& rms_a) noexcept {
  // T_i = (core + h_i (1 - 25 a)) / (1 - h_i a) with h_i = R12 R25 I_i^2; the loss follows from
  // T_i - core = R12 P_i, and core = room + R2 sum P is linear in the core.
  const double cold = 1.0 - 25.0 * kCopperPerKelvin;
  double constant_w = 0.0;
  double per_core_w_k = 0.0;
  for (int coil = 0; coil < kCoils; ++coil) {
    const double watt25 = rms_a[coil] * rms_a[coil] * coils.r25_ohm[static_cast<std::size_t>(coil)];
    const double left = 1.0 - thermal.winding_to_core_k_w * watt25 * kCopperPerKelvin;
    if (left <= 0.0) return std::numeric_limits<double>::infinity();
    constant_w += watt25 * cold / left;
    per_core_w_k += watt25 * kCopperPerKelvin / left;
  }
  const double left = 1.0 - to_room_k_w * per_core_w_k;
  if (left <= 0.0) return std::numeric_limits<double>::infinity();
  const double core_c = (room_c + to_room_k_w * constant_w) / left;
  double hottest = core_c;
  for (int coil = 0; coil < kCoils; ++coil) {
    const double h = thermal.winding_to_core_k_w * rms_a[coil] * rms_a[coil] *
                     coils.r25_ohm[static_cast<std::size_t>(coil)];
    hottest = std::max(hottest, (core_c + h * cold) / (1.0 - h * kCopperPerKelvin));
  }
  return hottest;
}

Vec3 along(int coil, double current_a) noexcept {
  Vec3 v;
  v[coil] = current_a;
  return v;
}

std::optional<double> sooner(std::optional<double> a, std::optional<double> b) noexcept {
  if (!a) return b;
  if (!b) return a;
  return std::min(*a, *b);
}

}  // namespace

Celsius derating_temperature(const Limits& limits, Amps peak) noexcept {
  const double full = limits.current_a;
  const double sustained = std::min(limits.continuous_a, full);
  const double a = std::clamp(peak.value, 0.0, full);
  if (a <= sustained) {
    const double share = sustained > 0.0 ? a / sustained : 0.0;
    return Celsius(limits.zero_c - (limits.zero_c - limits.sustain_c) * share);
  }
  const double share = (a * a - sustained * sustained) / (full * full - sustained * sustained);
  return Celsius(limits.sustain_c - (limits.sustain_c - limits.derate_from_c) * share);
}

std::optional<double> Forecaster::seconds_to_derating(const ForecastStart& start,
                                                      const AskedCurrents& asked) const noexcept {
  if (!(asked.peak_a > 0.0)) return std::nullopt;
  return time_to(Course(coils_, thermal_, start, asked.rms_a),
                 derating_temperature(limits_, Amps(asked.peak_a)).value, true);
}

std::optional<double> Forecaster::burst_s(const ForecastStart& start) const noexcept {
  std::optional<double> worst;
  for (int coil = 0; coil < kCoils; ++coil)
    worst = sooner(
        worst, seconds_to_derating(start, AskedCurrents::constant(along(coil, limits_.current_a))));
  return worst;
}

std::optional<double> Forecaster::recovery_s(const ForecastStart& start) const noexcept {
  return time_to(Course(coils_, thermal_, start, Vec3{}), limits_.derate_from_c, false);
}

double Forecaster::sustainable_a(const ForecastStart& start,
                                 const AskedCurrents& asked) const noexcept {
  const double length = norm(asked.rms_a);
  if (!(asked.peak_a > 0.0) || !(length > 0.0)) {
    double worst = limits_.current_a;
    for (int coil = 0; coil < kCoils; ++coil)
      worst = std::min(worst, sustainable_a(start, AskedCurrents::constant(along(coil, 1.0))));
    return worst;
  }
  const double to_room_k_w =
      start.fan_works ? thermal_.core_to_room_fan_k_w : thermal_.core_to_room_still_k_w;
  double low = 0.0;
  double high = limits_.current_a;
  for (int halving = 0; halving < 40; ++halving) {
    const double peak = 0.5 * (low + high);
    const double settled =
        settled_c(coils_, thermal_, start.room_c, to_room_k_w, (peak / asked.peak_a) * asked.rms_a);
    (settled < derating_temperature(limits_, Amps(peak)).value ? low : high) = peak;
  }
  return low;
}

Forecast Forecaster::under_load(const ForecastStart& start,
                                const AskedCurrents& asked) const noexcept {
  std::array<Crossing, 2> rise;
  rise[0].goal_c = limits_.trip_c;
  rise[1].goal_c = derating_temperature(limits_, Amps(asked.peak_a)).value;
  const bool derates = asked.peak_a > 0.0;
  await(Course(coils_, thermal_, start, asked.rms_a), std::span(rise).first(derates ? 2 : 1));
  Forecast f;
  f.seconds_to_limit = rise[0].at_s;
  f.seconds_to_derating = rise[1].at_s;
  f.sustainable_a = sustainable_a(start, asked);
  return f;
}

Forecast Forecaster::forecast(const ForecastStart& start,
                              const AskedCurrents& asked) const noexcept {
  Forecast f = under_load(start, asked);
  f.recovery_s = recovery_s(start);
  return f;
}

Forecast Forecaster::forecast_worst_coil(const ForecastStart& start,
                                         double current_a) const noexcept {
  Forecast worst = under_load(start, AskedCurrents::constant(along(0, current_a)));
  for (int coil = 1; coil < kCoils; ++coil) {
    const Forecast one = under_load(start, AskedCurrents::constant(along(coil, current_a)));
    worst.seconds_to_derating = sooner(worst.seconds_to_derating, one.seconds_to_derating);
    worst.seconds_to_limit = sooner(worst.seconds_to_limit, one.seconds_to_limit);
    worst.sustainable_a = std::min(worst.sustainable_a, one.sustainable_a);
  }
  worst.recovery_s = recovery_s(start);
  return worst;
}

}  // namespace hedgehog::model
