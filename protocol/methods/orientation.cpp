// SPDX-License-Identifier: MIT
#include "protocol/methods/orientation.h"

#include <cmath>
#include <utility>

namespace hedgehog::protocol {

void OrientationSet::describe(Fields& f) {
  f.required("quaternion", quaternion);
  if (f.checks()) normalise(f, "quaternion", quaternion);
}

void normalise(Fields& f, std::string_view field, model::Quaternion& q) {
  // Tolerance for quaternions rounded by clients.
  constexpr double kTolerance = 0.01;
  const double length = model::norm(q);
  if (!(std::fabs(length - 1.0) <= kTolerance)) {
    RpcError error = invalid_params(field, "is not of length 1");
    error.limit = std::int64_t{1};
    error.value = length;
    f.fail(std::move(error));
    return;
  }
  constexpr double kExact = 1e-12;
  if (std::fabs(length - 1.0) > kExact)
    q = {q.w / length, q.x / length, q.y / length, q.z / length};
}

}  // namespace hedgehog::protocol
