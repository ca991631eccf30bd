// SPDX-License-Identifier: MIT
#pragma once

#include "model/vec3.h"
#include "tests/e2e/raw_client.h"

namespace hedgehog::e2e {

/// A JSON array of three numbers.
inline model::Vec3 vector_of(const Json& xyz) { return {xyz[0], xyz[1], xyz[2]}; }

}  // namespace hedgehog::e2e
