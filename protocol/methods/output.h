// SPDX-License-Identifier: MIT
// output.*
#pragma once

#include <cstdint>

#include "protocol/method_info.h"
#include "protocol/wire/fields.h"

namespace hedgehog::protocol {

struct GainResult {
  static constexpr std::string_view kSchema = "Gain";
  double gain = 1.0;
  std::uint64_t seq = 0;

  void describe(Fields& f) {
    f.required("gain", gain, decimals(4));
    f.required("seq", seq);
  }
  friend bool operator==(const GainResult&, const GainResult&) = default;
};

struct OutputSetGain {
  static constexpr MethodInfo kMethod{"output.set_gain", Role::kOperate,
                                      "Gain applied to all effects; persistent."};
  using Result = GainResult;

  double gain = 1.0;

  void describe(Fields& f) { f.required("gain", gain, {.min = 0, .max = 1}); }
  friend bool operator==(const OutputSetGain&, const OutputSetGain&) = default;
};

using OutputMethods = TypeList<OutputSetGain>;

}  // namespace hedgehog::protocol
