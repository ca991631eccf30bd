// SPDX-License-Identifier: MIT
// Arbitrary bytes as calibration and as reports of both pads on both buses, with the decoded
// samples passed to the filter.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <vector>

#include "daemon/device/board_core/crc32.h"
#include "daemon/device/imu/fusion.h"
#include "daemon/device/imu/sony_pad.h"

namespace {

using namespace hedgehog::device;

void require(bool condition) {
  if (!condition) std::abort();
}

/// The rest of the input, truncated to the length of the report, with its id and, over Bluetooth,
/// with a valid CRC, so that the decoder behind the CRC is reached.
std::vector<Byte> report(std::span<const Byte> bytes, Byte id, std::size_t length, int seed) {
  std::vector<Byte> made(length);
  std::copy_n(bytes.begin(), std::min(bytes.size(), length), made.begin());
  made[0] = id;
  if (seed < 0) return made;
  std::vector<Byte> covered{static_cast<Byte>(seed)};
  covered.insert(covered.end(), made.begin(), made.end() - 4);
  const std::uint32_t crc = hedgehog::board::crc32(covered.data(), covered.size());
  for (std::size_t i = 0; i < 4; ++i) made[length - 4 + i] = static_cast<Byte>(crc >> (8 * i));
  return made;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const Byte* data, std::size_t size) {
  const std::span<const Byte> bytes(data, size);
  for (const SonyPad pad : {SonyPad::kDualSense, SonyPad::kDualShock4}) {
    (void)decode_sony(pad, bytes, SonyCalibration::nominal());
    for (const SonyBus bus : {SonyBus::kUsb, SonyBus::kBluetooth}) {
      (void)decode_calibration(pad, bus, bytes);
      const bool radio = bus == SonyBus::kBluetooth;
      const auto expected = calibration_report(pad, bus);
      const auto calibration = decode_calibration(
          pad, bus, report(bytes, expected.id, expected.bytes, radio ? 0xA3 : -1));
      require(calibration.has_value());
      const std::span<const Byte> rest = bytes.subspan(std::min<std::size_t>(size, 40));
      const Byte id = !radio ? 0x01 : pad == SonyPad::kDualSense ? 0x31 : 0x11;
      const auto sample =
          decode_sony(pad, report(rest, id, radio ? 78 : 64, radio ? 0xA1 : -1), *calibration);
      require(sample.has_value());
      require(norm(sample->rate_deg_s) < 2.5e4 && norm(sample->accel_g) < 50.0);
      require(sample->clock_us >= 0.0 && sample->clock_us < sony_clock_span_us(pad));
      Fusion fusion;
      fusion.step({sample->rate_deg_s, sample->accel_g, 0.004});
      fusion.step({sample->rate_deg_s, sample->accel_g, 0.004});
      require(std::abs(norm(fusion.sensor_to_world()) - 1.0) < 1e-9);
    }
  }
  return 0;
}
