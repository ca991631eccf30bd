// SPDX-License-Identifier: MIT
// Arbitrary bytes as the firmware's name and as temperatures.
#include <cstdlib>

#include "daemon/device/thermometer/temper.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace hedgehog::device;
  const std::span<const Byte> bytes(data, size);
  const auto named = temper_model(temper_firmware(bytes));
  for (const auto& model : {named, temper_model("TEMPerF1.4"), temper_model("TEMPer2_V3.9")}) {
    const auto reading = model ? decode_temper(*model, bytes) : std::nullopt;
    if (!reading) continue;
    for (const auto& value : {reading->internal_c, reading->external_c})
      if (value && !(*value >= -40.0 && *value <= 125.0)) std::abort();
  }
  return 0;
}
