// SPDX-License-Identifier: MIT
#include "protocol/wire/direction.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "model/geometry/direction.h"

namespace hedgehog::protocol {
namespace {

struct Resolver {
  const model::PinArray& pins;
  std::string_view field;

  Result<model::Vec3> operator()(const model::Vec3& v) const {
    const double longest = std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)});
    if (!model::is_finite(v) || longest == 0.0)
      return invalid_params(field, "a vector of length 0 is not a direction");
    // Scaled first, so that squares of tiny or huge components neither underflow nor overflow.
    return model::unit_or({v.x / longest, v.y / longest, v.z / longest}, {1, 0, 0});
  }
  Result<model::Vec3> operator()(const Angles& angles) const {
    return model::vector_of({angles.azimuth_deg, angles.elevation_deg});
  }
  Result<model::Vec3> operator()(const PinNumber& number) const {
    if (const model::Pin* pin = pins.find(number.pin)) return pin->position;
    const auto last = static_cast<double>(pins.pins.size()) - 1.0;
    return out_of_range(std::string(field) + ".pin", number.pin < 0 ? 0.0 : last,
                        static_cast<double>(number.pin));
  }
  Result<model::Vec3> operator()(Word enumerator) const {
    return model::kNamedDirections[static_cast<std::size_t>(enumerator)].vector;
  }
};

}  // namespace

Result<model::Vec3> resolve(const Direction& direction, const model::PinArray& pins,
                            std::string_view field) {
  return std::visit(Resolver{pins, field}, direction);
}

}  // namespace hedgehog::protocol
