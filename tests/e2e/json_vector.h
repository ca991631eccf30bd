// SPDX-License-Identifier: MIT
#pragma once

#include "model/quaternion.h"
#include "model/vec3.h"
#include "tests/e2e/raw_client.h"

namespace hedgehog::e2e {

/// A JSON array of three numbers.
inline model::Vec3 vector_of(const Json& xyz) { return {xyz[0], xyz[1], xyz[2]}; }

/// As the protocol has orientations.
inline Json json_of(const model::Quaternion& q) {
  return {{"w", q.w}, {"x", q.x}, {"y", q.y}, {"z", q.z}};
}

}  // namespace hedgehog::e2e
