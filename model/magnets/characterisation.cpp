// SPDX-License-Identifier: MIT
#include "model/magnets/characterisation.h"

#include <algorithm>
#include <cmath>

namespace hedgehog::model {
namespace {

struct Sample {
  double at = 0.0;
  double value = 0.0;
};

/// Root between two samples of opposite sign: regula falsi with Anderson-Bjorck damping, which
/// keeps the bracket. REQUIRES: the signs differ.
template <typename Function>
double root_between(const Function& f, Sample a, Sample b) {
  constexpr double kCloseMm = 1e-6;
  constexpr int kMaxSteps = 60;
  if (a.value == 0.0) return a.at;
  double last = a.at;
  for (int i = 0; i < kMaxSteps; ++i) {
    const double at = b.at - b.value * (b.at - a.at) / (b.value - a.value);
    const double value = f(at);
    if (value == 0.0 || std::abs(at - last) < kCloseMm) return at;
    last = at;
    if ((value < 0.0) == (b.value < 0.0)) {
      const double damping = 1.0 - value / b.value;
      a.value *= damping > 0.0 ? damping : 0.5;
    } else {
      a = b;
    }
    b = {at, value};
  }
  return last;
}

/// Position of the minimum of a parabola through three samples; the middle sample if it has none.
double vertex_of(const Sample& a, const Sample& b, const Sample& c) {
  const double left = (b.value - a.value) / (b.at - a.at);
  const double right = (c.value - b.value) / (c.at - b.at);
  const double bend = (right - left) / (c.at - a.at);
  if (!(bend > 0.0)) return b.at;
  return std::clamp(0.5 * (a.at + b.at) - 0.5 * left / bend, a.at, c.at);
}

/// Minimum between three samples of which the middle one is the lowest.
template <typename Function>
Sample minimum_between(const Function& f, Sample a, Sample b, Sample c) {
  constexpr double kCloseMm = 1e-3;
  constexpr int kMaxSteps = 8;
  for (int i = 0; i < kMaxSteps; ++i) {
    const double at = vertex_of(a, b, c);
    if (std::abs(at - b.at) < kCloseMm) break;
    const Sample sample{at, f(at)};
    const bool lower = sample.value < b.value;
    Sample& outer = at < b.at ? a : c;
    if (lower) {
      (at < b.at ? c : a) = b;
      b = sample;
    } else {
      outer = sample;
    }
  }
  return b;
}

Sample sample_of(const ForceCurve& curve, std::size_t i) {
  return {curve.offsets_mm[i], curve.force_n[i]};
}

double slope_at(const PinForce& force, double offset_mm) {
  constexpr double kStepMm = 0.02;
  return (force.at(offset_mm + kStepMm).force_n - force.at(offset_mm - kStepMm).force_n) /
         (2.0 * kStepMm);
}

/// Distance from `from` to where F + push first falls to zero.
std::optional<double> extension_under(const PinForce& force, const Characterisation& character,
                                      Sample from, const Push& push) {
  const auto total = [&](double offset_mm) {
    return force.at(offset_mm).force_n + push(offset_mm);
  };
  std::vector<Sample> samples;
  for (std::size_t i = 0; i < character.curve.offsets_mm.size(); ++i)
    samples.push_back(sample_of(character.curve, i));
  // The minimum may lie between grid points.
  samples.push_back({character.minimum_mm, character.minimum_n});
  std::sort(samples.begin(), samples.end(),
            [](const Sample& a, const Sample& b) { return a.at < b.at; });
  Sample before{from.at, from.value + push(from.at)};
  if (before.value <= 0.0) return 0.0;
  for (const Sample& sample : samples) {
    if (sample.at <= before.at) continue;
    const Sample here{sample.at, sample.value + push(sample.at)};
    if (here.value <= 0.0) return root_between(total, before, here) - from.at;
    before = here;
  }
  return std::nullopt;
}

/// REQUIRES: `rest_mm` and `shell_n` are set.
template <typename Function>
std::optional<double> standing_of(const Characterisation& character, const Function& value) {
  if (character.shell_n <= 0.0) return 0.0;
  if (character.rest_mm && *character.rest_mm > 0.0) return character.rest_mm;
  Sample before{0.0, character.shell_n};
  for (std::size_t i = 0; i < character.curve.offsets_mm.size(); ++i) {
    const Sample here = sample_of(character.curve, i);
    if (here.at <= 0.0) continue;
    if (before.value > 0.0 && here.value <= 0.0) return root_between(value, before, here);
    before = here;
  }
  return std::nullopt;
}

}  // namespace

Characterisation characterise(const PinForce& force, const OffsetGrid& grid) {
  Characterisation result;
  result.curve = force_curve(force, grid);
  const ForceCurve& curve = result.curve;
  const std::size_t points = curve.offsets_mm.size();
  const auto value = [&](double offset_mm) { return force.at(offset_mm).force_n; };
  std::size_t from = 0;
  for (std::size_t i = 0; i + 1 < points; ++i) {
    const Sample a = sample_of(curve, i);
    const Sample b = sample_of(curve, i + 1);
    if (!result.rest_mm && a.value > 0.0 && b.value <= 0.0) {
      result.rest_mm = root_between(value, a, b);
      result.stiffness_n_mm = -slope_at(force, *result.rest_mm);
      from = i + 1;
    } else if (result.rest_mm && a.value < 0.0 && b.value >= 0.0) {
      result.unstable_mm = root_between(value, a, b);
      break;
    }
  }
  const auto lowest = std::min_element(curve.force_n.begin() + static_cast<std::ptrdiff_t>(from),
                                       curve.force_n.end());
  const auto at = static_cast<std::size_t>(lowest - curve.force_n.begin());
  Sample minimum = sample_of(curve, at);
  if (at > 0 && at + 1 < points)
    minimum = minimum_between(value, sample_of(curve, at - 1), minimum, sample_of(curve, at + 1));
  result.minimum_mm = minimum.at;
  result.minimum_n = minimum.value;
  result.shell_n = value(0.0);
  result.standing_mm = standing_of(result, value);
  return result;
}

std::vector<Characterisation> characterise(const std::vector<PinClass>& classes,
                                           const ArraySizes& sizes, const ForceSettings& settings,
                                           const OffsetGrid& grid) {
  std::vector<Characterisation> all;
  all.reserve(classes.size());
  for (const PinClass& pin_class : classes)
    all.push_back(characterise(PinForce(pin_class, sizes, settings), grid));
  return all;
}

std::optional<double> extension_mm(const PinForce& force, const Characterisation& character,
                                   double coil_force_n) {
  if (!character.rest_mm) return std::nullopt;
  return extension_under(force, character, {*character.rest_mm, 0.0}, constant_push(coil_force_n));
}

std::optional<double> extension_mm(const PinForce& force, const Characterisation& character,
                                   const Electromagnet& coil, double current_a) {
  if (!character.rest_mm) return std::nullopt;
  return extension_under(force, character, {*character.rest_mm, 0.0},
                         coil_push(coil, current_a, force.sizes()));
}

Push constant_push(double force_n) {
  return [force_n](double) { return force_n; };
}

Push coil_push(const Electromagnet& coil, double current_a, const ArraySizes& sizes) {
  return [=](double offset_mm) {
    return coil_force_n(coil, current_a, sizes.pin, sizes.sphere_radius_mm, 0.0, offset_mm);
  };
}

std::optional<Stroke> stroke(const PinForce& force, const Characterisation& character,
                             const Push& push, const PinTravel& travel) {
  if (!character.standing_mm) return std::nullopt;
  const double from_mm = *character.standing_mm;
  const double max_mm = std::max(0.0, travel.highest_mm - from_mm);
  const auto moved_mm = extension_under(force, character, {from_mm, -character.preload_n()}, push);
  if (moved_mm && *moved_mm <= max_mm) return Stroke{*moved_mm, false, false};
  return Stroke{max_mm, true, !moved_mm};
}

}  // namespace hedgehog::model
