// SPDX-License-Identifier: MIT
#include "clients/design/search/pull.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace hedgehog::design {
namespace {

constexpr std::size_t kNodes = 6;
// Accuracy of each pair. A test compares the thesis' ball with the full computation: within 0.002
// mm.
constexpr model::ForceSettings kSettings{model::ForceModel::kExact, 1e-4};

/// Chebyshev points, or all diameters if there are no more than that.
std::vector<double> nodes_for(const std::vector<double>& diameters_mm) {
  if (diameters_mm.size() <= kNodes) return diameters_mm;
  const double middle = 0.5 * (diameters_mm.front() + diameters_mm.back());
  const double half = 0.5 * (diameters_mm.back() - diameters_mm.front());
  std::vector<double> nodes;
  for (std::size_t i = 0; i < kNodes; ++i) {
    const double turn = std::numbers::pi * (2.0 * static_cast<double>(i) + 1.0) / (2.0 * kNodes);
    nodes.push_back(middle - half * std::cos(turn));
  }
  return nodes;
}

/// Lagrange's weights for the barycentric formula.
std::vector<double> weights_for(const std::vector<double>& nodes) {
  std::vector<double> weights(nodes.size(), 1.0);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    for (std::size_t j = 0; j < nodes.size(); ++j)
      if (i != j) weights[i] /= nodes[i] - nodes[j];
  }
  return weights;
}

}  // namespace

Pull::Pull(const model::PinClass& pin_class, const model::ArraySizes& sizes,
           const std::vector<double>& diameters_mm)
    : nodes_mm_(nodes_for(diameters_mm)), weights_(weights_for(nodes_mm_)) {
  const model::PinClass pins_only{pin_class.pins, pin_class.to_pins, {}};
  const model::PinClass shields_only{pin_class.pins, {}, pin_class.to_shields};
  from_pins_n_ =
      model::force_curve(model::PinForce(pins_only, sizes, kSettings), kSearchGrid).force_n;
  for (const double diameter_mm : nodes_mm_) {
    model::ArraySizes with = sizes;
    with.shield.diameter_mm = diameter_mm;
    auto force_n =
        model::force_curve(model::PinForce(shields_only, with, kSettings), kSearchGrid).force_n;
    for (double& force : force_n) force /= diameter_mm * diameter_mm;
    from_shields_.push_back(std::move(force_n));
  }
}

std::vector<double> Pull::force_n(double diameter_mm, double strength) const {
  std::vector<double> part(nodes_mm_.size(), 0.0);
  const auto at_node = std::find_if(nodes_mm_.begin(), nodes_mm_.end(), [&](double node) {
    return std::abs(node - diameter_mm) < 1e-9;
  });
  if (at_node != nodes_mm_.end()) {
    part[static_cast<std::size_t>(at_node - nodes_mm_.begin())] = 1.0;
  } else {
    double sum = 0.0;
    for (std::size_t i = 0; i < part.size(); ++i)
      sum += part[i] = weights_[i] / (diameter_mm - nodes_mm_[i]);
    for (double& one : part) one /= sum;
  }
  std::vector<double> force = from_pins_n_;
  const double scale = strength * diameter_mm * diameter_mm;
  for (std::size_t node = 0; node < part.size(); ++node)
    for (std::size_t i = 0; i < force.size(); ++i)
      force[i] += scale * part[node] * from_shields_[node][i];
  return force;
}

double falls_through(const std::vector<double>& force_n, double level_n,
                     std::size_t from) noexcept {
  const std::size_t last = force_n.size() - 1;
  for (std::size_t i = from; i < last; ++i) {
    if (!(force_n[i] > level_n && force_n[i + 1] <= level_n)) continue;
    // The cubic through four neighbours, at u in 0..1 between the middle two.
    const std::size_t first = std::min(i == 0 ? 0 : i - 1, last - 3);
    const double shift = static_cast<double>(i - first);
    const auto cubic = [&](double u) {
      double value = 0.0;
      for (std::size_t a = 0; a < 4; ++a) {
        double term = force_n[first + a];
        for (std::size_t b = 0; b < 4; ++b) {
          if (a == b) continue;
          term *= (shift + u - static_cast<double>(b)) /
                  (static_cast<double>(a) - static_cast<double>(b));
        }
        value += term;
      }
      return value - level_n;
    };
    double low = 0.0;
    double high = 1.0;
    for (int step = 0; step < 40; ++step) {
      const double middle = 0.5 * (low + high);
      (cubic(middle) > 0.0 ? low : high) = middle;
    }
    return kSearchGrid.first_mm +
           (static_cast<double>(i) + 0.5 * (low + high)) * kSearchGrid.step_mm;
  }
  return std::numeric_limits<double>::quiet_NaN();
}

}  // namespace hedgehog::design
