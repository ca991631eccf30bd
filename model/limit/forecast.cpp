// SPDX-License-Identifier: MIT
#include "model/limit/forecast.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

#include "model/limit/heat_course.h"
#include "model/limit/shell_limit.h"

namespace hedgehog::model {
namespace {

/// Temperatures that limit the current, C.
struct Heat {
  double hottest_c = 0.0;
  double skin_c = 0.0;

  explicit Heat(const HeatCourse& course) noexcept
      : hottest_c(course.hottest_c()), skin_c(course.skin_c()) {}
};

/// Temperature thresholds to detect on a course: rising, either of them; falling, both.
struct Crossing {
  double goal_c = 0.0;
  double skin_goal_c = std::numeric_limits<double>::infinity();
  bool rising = true;
  std::optional<double> at_s{};

  bool reached(const Heat& heat) const noexcept {
    return rising ? heat.hottest_c >= goal_c || heat.skin_c >= skin_goal_c
                  : heat.hottest_c <= goal_c && heat.skin_c <= skin_goal_c;
  }
  /// Fraction of the step from `before`, not reached, to `now`, reached, at the crossing.
  double share(const Heat& before, const Heat& now) const noexcept {
    const double by_winding = share(before.hottest_c, now.hottest_c, goal_c);
    const double by_skin = share(before.skin_c, now.skin_c, skin_goal_c);
    return rising ? std::min(by_winding, by_skin) : std::max(by_winding, by_skin);
  }

 private:
  double share(double before_c, double now_c, double goal) const noexcept {
    const bool was = rising ? before_c >= goal : before_c <= goal;
    const bool is = rising ? now_c >= goal : now_c <= goal;
    if (was) return 0.0;
    return is ? (goal - before_c) / (now_c - before_c) : 1.0;
  }
};

/// Time at which each of `crossings` is first reached; runs until the last of them.
void await(HeatCourse course, std::span<Crossing> crossings) noexcept {
  Heat before(course);
  bool open = false;
  for (Crossing& c : crossings) {
    if (c.reached(before)) c.at_s = 0.0;
    open = open || !c.at_s;
  }
  for (bool more = true; more && open;) {
    const double before_s = course.time_s();
    more = course.step();
    const Heat now(course);
    open = false;
    for (Crossing& c : crossings) {
      if (c.at_s) continue;
      if (!std::isfinite(now.hottest_c)) {
        if (c.rising) c.at_s = before_s;
        continue;
      }
      if (c.reached(now))
        c.at_s = before_s + c.share(before, now) * (course.time_s() - before_s);
      else
        open = true;
    }
    before = now;
  }
}

/// Threshold above which less than `peak_a` is allowed.
Crossing derating_at(const Limits& limits, const ForecastStart& start, double peak_a) noexcept {
  const Amps peak(std::min(peak_a, limits.current_a));
  return {derating_temperature(limits, peak).value - start.above_k,
          shell_derating_temperature(peak).value};
}

std::optional<double> time_to(const HeatCourse& course, Crossing crossing) noexcept {
  await(course, {&crossing, 1});
  return crossing.at_s;
}

struct Settled {
  double hottest_c = std::numeric_limits<double>::infinity();
  double core_c = std::numeric_limits<double>::infinity();
};

/// Steady state with `rms_a`, by the fixed point in closed form; infinity in thermal runaway of the
/// copper.
Settled settled(const CoilModel& coils, const ThermalModel& thermal, double ambient_c,
                double to_ambient_k_w, const Vec3& rms_a) noexcept {
  // T_i = (core + h_i (1 - 25 a)) / (1 - h_i a) with h_i = R12 R25 I_i^2; the loss follows from T_i
  // - core = R12 P_i, and core = ambient + R2 sum P is linear in the core.
  const double cold = 1.0 - 25.0 * kCopperPerKelvin;
  double constant_w = 0.0;
  double per_core_w_k = 0.0;
  for (int coil = 0; coil < kCoils; ++coil) {
    const auto i = static_cast<std::size_t>(coil);
    const double watt25 = rms_a[coil] * rms_a[coil] * coils.r25_ohm[i];
    const double left = 1.0 - thermal.winding_to_core_k_w[i] * watt25 * kCopperPerKelvin;
    if (left <= 0.0) return {};
    constant_w += watt25 * cold / left;
    per_core_w_k += watt25 * kCopperPerKelvin / left;
  }
  const double left = 1.0 - to_ambient_k_w * per_core_w_k;
  if (left <= 0.0) return {};
  const double core_c = (ambient_c + to_ambient_k_w * constant_w) / left;
  double hottest = core_c;
  for (int coil = 0; coil < kCoils; ++coil) {
    const auto i = static_cast<std::size_t>(coil);
    const double h = thermal.winding_to_core_k_w[i] * rms_a[coil] * rms_a[coil] * coils.r25_ohm[i];
    hottest = std::max(hottest, (core_c + h * cold) / (1.0 - h * kCopperPerKelvin));
  }
  return {hottest, core_c};
}

/// True only if neither temperature of `rise` is ever reached. The system is monotone, so the nodes
/// stay below any state that is above them now and does not rise, even without fan: a core not
/// cooler than its steady state, with the windings in steady state at that core.
bool stays_below(const CoilModel& coils, const ThermalModel& thermal, const ForecastStart& start,
                 const Vec3& rms_a, const Crossing& rise) noexcept {
  // Covers rounding and unequal windings (forecast_core_c).
  constexpr double kMarginK = 0.5;
  const ThermalState& nodes = start.nodes;
  const double to_ambient_k_w =
      std::max(thermal.core_to_ambient_fan_k_w, thermal.core_to_ambient_still_k_w);
  double core_c = settled(coils, thermal, start.ambient_c, to_ambient_k_w, rms_a).core_c;
  double sum_c = nodes.core_c;
  core_c = std::max(core_c, nodes.core_c);
  std::array<double, kCoils> rise_per_k{};
  for (std::size_t i = 0; i < kCoils; ++i) {
    const double square_a2 = rms_a[static_cast<int>(i)] * rms_a[static_cast<int>(i)];
    rise_per_k[i] = thermal.winding_to_core_k_w[i] * square_a2 * coils.r25_ohm[i];
    const double copper = 1.0 + kCopperPerKelvin * (nodes.winding_c[i] - 25.0);
    core_c = std::max(core_c, nodes.winding_c[i] - rise_per_k[i] * copper);
    sum_c += nodes.winding_c[i];
  }
  if (!std::isfinite(sum_c) || !std::isfinite(core_c)) return false;
  double hottest_c = core_c;
  for (const double h : rise_per_k)
    hottest_c = std::max(
        hottest_c, (core_c + h * (1.0 - 25.0 * kCopperPerKelvin)) / (1.0 - h * kCopperPerKelvin));
  const double skin_c =
      std::max(start.skin.following_c(), settled_skin_c(core_c, start.ambient_c)) +
      start.skin_above_k;
  return hottest_c + kMarginK < rise.goal_c && skin_c + kMarginK < rise.skin_goal_c;
}

Vec3 along(int coil, double current_a) noexcept {
  Vec3 v;
  v[coil] = current_a;
  return v;
}

std::optional<double> earliest(std::optional<double> a, std::optional<double> b) noexcept {
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

std::optional<double> Forecaster::seconds_to_derating(
    const ForecastStart& start, const RequestedCurrents& requested) const noexcept {
  if (!(requested.peak_a > 0.0)) return std::nullopt;
  const Crossing derating = derating_at(limits_, start, requested.peak_a);
  if (stays_below(coils_, thermal_, start, requested.rms_a, derating)) return std::nullopt;
  return time_to(HeatCourse(coils_, thermal_, start, requested.rms_a), derating);
}

std::optional<double> Forecaster::burst_s(const ForecastStart& start) const noexcept {
  std::optional<double> worst;
  for (int coil = 0; coil < kCoils; ++coil)
    worst = earliest(
        worst,
        seconds_to_derating(start, RequestedCurrents::constant(along(coil, limits_.current_a))));
  return worst;
}

std::optional<double> Forecaster::recovery_s(const ForecastStart& start) const noexcept {
  return time_to(HeatCourse(coils_, thermal_, start, Vec3{}),
                 {limits_.derate_from_c - start.above_k,
                  shell_derating_temperature(Amps(limits_.current_a)).value, false});
}

double Forecaster::sustainable_a(const ForecastStart& start,
                                 const RequestedCurrents& requested) const noexcept {
  const double length = norm(requested.rms_a);
  if (!(requested.peak_a > 0.0) || !(length > 0.0)) {
    double worst = limits_.current_a;
    for (int coil = 0; coil < kCoils; ++coil)
      worst = std::min(worst, sustainable_a(start, RequestedCurrents::constant(along(coil, 1.0))));
    return worst;
  }
  const double to_ambient_k_w =
      start.fan_works ? thermal_.core_to_ambient_fan_k_w : thermal_.core_to_ambient_still_k_w;
  double low = 0.0;
  double high = limits_.current_a;
  for (int halving = 0; halving < 40; ++halving) {
    const double peak = 0.5 * (low + high);
    const Settled end = settled(coils_, thermal_, start.ambient_c, to_ambient_k_w,
                                (peak / requested.peak_a) * requested.rms_a);
    const Crossing derating = derating_at(limits_, start, peak);
    const double skin_c = settled_skin_c(end.core_c, start.ambient_c) + start.skin_above_k;
    const bool unreduced = end.hottest_c < derating.goal_c && !(skin_c >= derating.skin_goal_c);
    (unreduced ? low : high) = peak;
  }
  return low;
}

Forecast Forecaster::under_load(const ForecastStart& start,
                                const RequestedCurrents& requested) const noexcept {
  std::array<Crossing, 2> rise;
  rise[0].goal_c = limits_.trip_c;
  rise[1] = derating_at(limits_, start, requested.peak_a);
  const bool derates = requested.peak_a > 0.0;
  await(HeatCourse(coils_, thermal_, start, requested.rms_a),
        std::span(rise).first(derates ? 2 : 1));
  Forecast f;
  f.seconds_to_limit = rise[0].at_s;
  f.seconds_to_derating = rise[1].at_s;
  f.sustainable_a = sustainable_a(start, requested);
  return f;
}

Forecast Forecaster::forecast(const ForecastStart& start,
                              const RequestedCurrents& requested) const noexcept {
  Forecast f = under_load(start, requested);
  f.recovery_s = recovery_s(start);
  return f;
}

Forecast Forecaster::forecast_worst_coil(const ForecastStart& start,
                                         double current_a) const noexcept {
  Forecast worst = under_load(start, RequestedCurrents::constant(along(0, current_a)));
  for (int coil = 1; coil < kCoils; ++coil) {
    const Forecast one = under_load(start, RequestedCurrents::constant(along(coil, current_a)));
    worst.seconds_to_derating = earliest(worst.seconds_to_derating, one.seconds_to_derating);
    worst.seconds_to_limit = earliest(worst.seconds_to_limit, one.seconds_to_limit);
    worst.sustainable_a = std::min(worst.sustainable_a, one.sustainable_a);
  }
  worst.recovery_s = recovery_s(start);
  return worst;
}

}  // namespace hedgehog::model
