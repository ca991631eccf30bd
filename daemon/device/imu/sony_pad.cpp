// SPDX-License-Identifier: MIT
#include "daemon/device/imu/sony_pad.h"

#include <algorithm>
#include <cmath>

#include "base/crc32.h"

namespace hedgehog::device {
namespace {

// Over Bluetooth the check sum includes the byte that announces the transaction.
constexpr Byte kInputSeed = 0xA1;
constexpr Byte kFeatureSeed = 0xA3;
constexpr std::size_t kLongest = 78;

bool crc_fits(Byte seed, std::span<const Byte> report) noexcept {
  std::array<Byte, 1 + kLongest> covered{};
  if (report.size() < 4 || report.size() > kLongest) return false;
  covered[0] = seed;
  std::copy(report.begin(), report.end() - 4, covered.begin() + 1);
  return base::crc32(std::as_bytes(std::span(covered).first(report.size() - 3))) ==
         little_u32(&report[report.size() - 4]);
}

struct Layout {
  Byte id = 0;
  std::size_t bytes = 0;
  bool crc = false;
  std::size_t gyro = 0;
  std::size_t accel = 0;
  std::size_t clock = 0;
};
constexpr Layout kDualSenseUsb{0x01, 64, false, 16, 22, 28};
constexpr Layout kDualSenseBluetooth{0x31, 78, true, 17, 23, 29};
constexpr Layout kDualShock4Usb{0x01, 64, false, 13, 19, 10};
constexpr Layout kDualShock4Bluetooth{0x11, 78, true, 15, 21, 12};

std::optional<Layout> layout_of(SonyPad pad, std::span<const Byte> report) noexcept {
  const bool new_pad = pad == SonyPad::kDualSense;
  for (const Layout& layout : {new_pad ? kDualSenseUsb : kDualShock4Usb,
                               new_pad ? kDualSenseBluetooth : kDualShock4Bluetooth}) {
    if (report.size() == layout.bytes && report[0] == layout.id) {
      if (layout.crc && !crc_fits(kInputSeed, report)) return std::nullopt;
      return layout;
    }
  }
  return std::nullopt;
}

constexpr double kGyroRangeDegS = 2048.0;
constexpr double kAccelRangeG = 4.0;
constexpr double kRawRange = 32767.0;
constexpr SonyCalibration::Axis kNominalGyro{0.0, kGyroRangeDegS / kRawRange};
constexpr SonyCalibration::Axis kNominalAccel{0.0, kAccelRangeG / kRawRange};

/// Genuine pads are within a few per cent of nominal; other values are not a calibration.
SonyCalibration::Axis plausible_or(const SonyCalibration::Axis& axis,
                                   const SonyCalibration::Axis& nominal) noexcept {
  const double ratio = axis.scale / nominal.scale;
  const bool good = ratio > 0.5 && ratio < 2.0 && std::abs(axis.bias) < kRawRange / 4;
  return good ? axis : nominal;
}

model::Vec3 physical(const Byte* at, const std::array<SonyCalibration::Axis, 3>& axes) noexcept {
  std::array<double, 3> pad{};
  for (std::size_t i = 0; i < 3; ++i)
    pad[i] = (little_i16(at + 2 * i) - axes[i].bias) * axes[i].scale;
  return {-pad[2], -pad[0], pad[1]};
}

double clock_unit_us(SonyPad pad) noexcept {
  return pad == SonyPad::kDualSense ? 1.0 / 3.0 : 16.0 / 3.0;
}

}  // namespace

SonyCalibrationReport calibration_report(SonyPad pad, SonyBus bus) noexcept {
  if (pad == SonyPad::kDualSense) return {0x05, 41};
  return bus == SonyBus::kUsb ? SonyCalibrationReport{0x02, 37} : SonyCalibrationReport{0x05, 41};
}

SonyCalibration SonyCalibration::nominal() noexcept {
  SonyCalibration made;
  made.gyro.fill(kNominalGyro);
  made.accel.fill(kNominalAccel);
  return made;
}

std::optional<SonyCalibration> decode_calibration(SonyPad pad, SonyBus bus,
                                                  std::span<const Byte> report) noexcept {
  const SonyCalibrationReport expected = calibration_report(pad, bus);
  if (report.size() != expected.bytes || report[0] != expected.id) return std::nullopt;
  if (bus == SonyBus::kBluetooth && !crc_fits(kFeatureSeed, report)) return std::nullopt;
  const auto at = [&](std::size_t byte) { return double{1.0} * little_i16(&report[byte]); };

  // The DualShock 4 lists its three maxima first over Bluetooth; otherwise pairs, axis by axis.
  const bool pairs = pad == SonyPad::kDualSense || bus == SonyBus::kUsb;
  const double speeds = at(19) + at(21);
  SonyCalibration made;
  for (std::size_t i = 0; i < 3; ++i) {
    const double factory_bias = at(1 + 2 * i);
    const double gyro_plus = at(pairs ? 7 + 4 * i : 7 + 2 * i) - factory_bias;
    const double gyro_minus = at(pairs ? 9 + 4 * i : 13 + 2 * i) - factory_bias;
    // Reports do not contain that bias: it applies only to the two maxima.
    made.gyro[i] =
        plausible_or({0.0, speeds / (std::abs(gyro_plus) + std::abs(gyro_minus))}, kNominalGyro);
    const double accel_plus = at(23 + 4 * i);
    const double range_2g = accel_plus - at(25 + 4 * i);
    made.accel[i] = plausible_or({accel_plus - range_2g / 2, 2.0 / range_2g}, kNominalAccel);
  }
  return made;
}

std::optional<SonySample> decode_sony(SonyPad pad, std::span<const Byte> report,
                                      const SonyCalibration& calibration) noexcept {
  const auto layout = layout_of(pad, report);
  if (!layout) return std::nullopt;
  SonySample sample;
  sample.rate_deg_s = physical(&report[layout->gyro], calibration.gyro);
  sample.accel_g = physical(&report[layout->accel], calibration.accel);
  const Byte* clock = &report[layout->clock];
  sample.clock_us =
      clock_unit_us(pad) * (pad == SonyPad::kDualSense ? little_u32(clock) : little_u16(clock));
  return sample;
}

double sony_clock_span_us(SonyPad pad) noexcept {
  return clock_unit_us(pad) * (pad == SonyPad::kDualSense ? 0x1.0p32 : 0x1.0p16);
}

double sony_elapsed_s(SonyPad pad, double before_us, double after_us) noexcept {
  const double difference = after_us - before_us;
  return 1e-6 * (difference < 0.0 ? difference + sony_clock_span_us(pad) : difference);
}

}  // namespace hedgehog::device
