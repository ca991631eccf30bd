// SPDX-License-Identifier: MIT
#include "model/magnets/pin_curves.h"

#include <algorithm>
#include <cmath>

#include "model/magnets/electromagnet.h"
#include "model/magnets/force_curve.h"

namespace hedgehog::model {

PinCurves::PinCurves(const Arrangement& arrangement, const ArraySizes& sizes,
                     const PinTravel& travel)
    : travel_(travel), class_of_(arrangement.pins.size()) {
  // A relative force error of 1e-4 corresponds to 1e-4 mm here.
  constexpr ForceSettings kSettings{ForceModel::kExact, 1e-4};
  const double step_mm = (travel.highest_mm - travel.lowest_mm) / (kPoints - 1);
  const OffsetGrid grid{travel.lowest_mm, travel.highest_mm, step_mm};
  const auto push = [&](double offset_mm) {
    return force_per_moment_n(sizes.pin, sizes.sphere_radius_mm, offset_mm);
  };
  const std::vector<PinClass> classes = symmetry_classes(arrangement);
  const std::vector<ForceCurve> curves = force_curves(classes, sizes, kSettings, grid);
  for (std::size_t c = 0; c < classes.size(); ++c) {
    const PinClass& pin_class = classes[c];
    const ForceCurve& curve = curves[c];
    Class one;
    for (std::size_t i = 0; i < kPoints; ++i) {
      one.holding[i] = -curve.force_n[i] / push(curve.offsets_mm[i]);
      // Beyond the strongest inward force the pin is expelled.
      if (i > 0) one.holding[i] = std::max(one.holding[i], one.holding[i - 1]);
    }
    for (std::size_t i = 0; i < arrangement.pins.size(); ++i)
      if (std::binary_search(pin_class.pins.begin(), pin_class.pins.end(), arrangement.pins[i].id))
        class_of_[i] = static_cast<std::uint16_t>(classes_.size());
    classes_.push_back(one);
  }
  // The rest position does not depend on the scale of the push.
  typical_rest_mm_ = median_rest_mm();
  for (std::size_t pin = 0; pin < size(); ++pin)
    classes_[class_of_[pin]].share_at_rest = push(rest_mm(pin)) / push(typical_rest_mm_);
  for (Class& one : classes_)
    for (double& force : one.holding) force *= push(typical_rest_mm_);
}

double PinCurves::median_rest_mm() const {
  if (size() == 0) return 0.0;
  std::vector<double> rests;
  for (std::size_t pin = 0; pin < size(); ++pin) rests.push_back(rest_mm(pin));
  const auto middle = rests.begin() + static_cast<std::ptrdiff_t>((rests.size() - 1) / 2);
  std::nth_element(rests.begin(), middle, rests.end());
  return *middle;
}

double PinCurves::offset_mm(std::size_t pin, double coil_force_n) const noexcept {
  const HoldingForce& holding = classes_[class_of_[pin]].holding;
  const double force = std::isnan(coil_force_n) ? 0.0 : coil_force_n;
  const auto above = std::upper_bound(holding.begin(), holding.end(), force);
  if (above == holding.begin()) return travel_.lowest_mm;
  if (above == holding.end()) return travel_.highest_mm;
  const double before = *(above - 1);
  const double place =
      static_cast<double>(above - 1 - holding.begin()) + (force - before) / (*above - before);
  return travel_.lowest_mm +
         place * (travel_.highest_mm - travel_.lowest_mm) / static_cast<double>(kPoints - 1);
}

void PinCurves::extensions_mm(std::span<const double> coil_forces_n,
                              std::span<double> extensions_mm) const noexcept {
  for (std::size_t i = 0; i < size(); ++i) extensions_mm[i] = extension_mm(i, coil_forces_n[i]);
}

}  // namespace hedgehog::model
