// SPDX-License-Identifier: MIT
#include "model/magnets/symmetry_classes.h"

#include <algorithm>
#include <cmath>

namespace hedgehog::model {
namespace {

/// Angles from a pin to all other magnets, ascending.
struct View {
  std::vector<double> pins_deg;
  std::vector<double> shields_deg;
};

View view_from(const MagnetSite& pin, const Arrangement& arrangement) {
  View view;
  for (const MagnetSite& other : arrangement.pins) {
    if (other.id == pin.id) continue;
    view.pins_deg.push_back(angle_deg(pin.direction, other.direction));
  }
  for (const MagnetSite& shield : arrangement.shields)
    view.shields_deg.push_back(angle_deg(pin.direction, shield.direction));
  std::sort(view.pins_deg.begin(), view.pins_deg.end());
  std::sort(view.shields_deg.begin(), view.shields_deg.end());
  return view;
}

bool same(const std::vector<double>& a, const std::vector<double>& b) {
  return std::equal(
      a.begin(), a.end(), b.begin(), b.end(),
      [](double x, double y) { return std::abs(x - y) <= kSameAngleDeg; });
}

/// Merges equal adjacent angles into their mean.
std::vector<AngleCount> counted(const std::vector<double>& angles_deg) {
  std::vector<AngleCount> counts;
  double first_deg = 0.0;
  for (const double angle_deg : angles_deg) {
    if (counts.empty() || angle_deg - first_deg > kSameAngleDeg) {
      counts.push_back({angle_deg, 1});
      first_deg = angle_deg;
    } else {
      AngleCount& last = counts.back();
      ++last.count;
      last.angle_deg += (angle_deg - last.angle_deg) / last.count;
    }
  }
  return counts;
}

double nearest_deg(const PinClass& pin_class) {
  return pin_class.to_shields.empty() ? 180.0 : pin_class.to_shields.front().angle_deg;
}

}  // namespace

std::vector<PinClass> symmetry_classes(const Arrangement& arrangement) {
  std::vector<PinClass> classes;
  std::vector<View> views;
  for (const MagnetSite& pin : arrangement.pins) {
    View view = view_from(pin, arrangement);
    const auto known = std::find_if(views.begin(), views.end(), [&](const View& other) {
      return same(view.pins_deg, other.pins_deg) && same(view.shields_deg, other.shields_deg);
    });
    if (known != views.end()) {
      classes[static_cast<std::size_t>(known - views.begin())].pins.push_back(pin.id);
      continue;
    }
    classes.push_back({{pin.id}, counted(view.pins_deg), counted(view.shields_deg)});
    views.push_back(std::move(view));
  }
  // The arrangement's pins may be in any order.
  for (PinClass& pin_class : classes) std::sort(pin_class.pins.begin(), pin_class.pins.end());
  std::stable_sort(classes.begin(), classes.end(), [](const PinClass& a, const PinClass& b) {
    return nearest_deg(a) + kSameAngleDeg < nearest_deg(b);
  });
  return classes;
}

}  // namespace hedgehog::model
