// SPDX-License-Identifier: MIT
// An error injected by sim.set, also part of its result.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "protocol/wire/fields.h"

namespace hedgehog::protocol {

inline constexpr std::size_t kMaxSimErrors = 32;

/// An error of the simulated board's measurements, or of the simulated ball.
struct SimError {
  std::string kind{};  // wire name of device::SimulatorErrorKind; checked by the server
  std::optional<std::int64_t> coil{};  // for kinds that affect one winding
  double value = 0.0;
  double ramp_s = 0.0;  // duration of the linear increase

  void describe(Fields& f) {
    f.required("kind", kind, {.min = 1, .max = 40});
    f.optional("coil", coil, {.min = 0, .max = 2});
    f.required("value", value);
    f.defaulted("ramp_s", ramp_s, {.min = 0, .max = 86400});
  }
  friend bool operator==(const SimError&, const SimError&) = default;
};

}  // namespace hedgehog::protocol
