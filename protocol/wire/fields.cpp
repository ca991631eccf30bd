// SPDX-License-Identifier: MIT
#include "protocol/wire/fields.h"

namespace hedgehog::protocol {

void Angles::describe(Fields& f) {
  f.defaulted("azimuth_deg", azimuth_deg, {.min = -360, .max = 360});
  f.defaulted("elevation_deg", elevation_deg, {.min = -90, .max = 90});
}

void PinNumber::describe(Fields& f) { f.required("pin", pin, {.min = 0}); }

void Fields::direction(Direction& v) {
  if (reads()) {
    switch (kind()) {
      case Kind::kList:
        v = model::Vec3{};
        break;
      case Kind::kObject:
        if (has("pin")) {
          v = PinNumber{};
        } else if (has("azimuth_deg") || has("elevation_deg")) {
          v = Angles{};
        } else {
          fail(invalid_params(path(),
                              "an object here is {\"azimuth_deg\", \"elevation_deg\"} or "
                              "{\"pin\"}"));
          return;
        }
        break;
      case Kind::kString:
        v = Word{};
        break;
      default:
        fail(invalid_params(path(),
                            "must be a word such as \"left\", a vector [x,y,z], {\"azimuth_deg\", "
                            "\"elevation_deg\"} or {\"pin\"}"));
        return;
    }
  }
  std::visit([&](auto& given) { value(given); }, v);
  const auto* vector = std::get_if<model::Vec3>(&v);
  if (checks() && vector != nullptr && *vector == model::Vec3{})
    fail(invalid_params(path(), "[0,0,0] is not a direction"));
}

}  // namespace hedgehog::protocol
