// SPDX-License-Identifier: MIT
// Gyroscope and accelerometer of Sony's DualSense and DualShock 4, by USB and by Bluetooth, with
// the calibration stored in each pad. Source: byte positions and use of the calibration as in
// Linux' hid-playstation.c (reference: hardware.md section 5.2): the gyroscope's factory bias is
// subtracted from the maxima that were measured with it, and is not contained in the reports. Pure;
// any thread.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "daemon/device/byte_order.h"
#include "model/vec3.h"

namespace hedgehog::device {

enum class SonyPad : std::uint8_t { kDualSense, kDualShock4 };
enum class SonyBus : std::uint8_t { kUsb, kBluetooth };

/// The feature report with the calibration: its id, and its length including the id.
struct SonyCalibrationReport {
  std::uint8_t id = 0;
  std::size_t bytes = 0;
};
SonyCalibrationReport calibration_report(SonyPad pad, SonyBus bus) noexcept;

/// raw -> physical of each axis, (raw - bias) * scale, in the pad's order x (right), y (up out of
/// its face), z (to the player).
struct SonyCalibration {
  struct Axis {
    double bias = 0.0;
    double scale = 0.0;
  };
  std::array<Axis, 3> gyro;   // deg/s
  std::array<Axis, 3> accel;  // g

  /// The ranges of the data sheet: +-2048 deg/s, +-4 g.
  static SonyCalibration nominal() noexcept;
};

/// nullopt for a wrong id, length or (Bluetooth) CRC. An axis with implausible numbers (a copy of a
/// pad sends zeros) gets its nominal values.
std::optional<SonyCalibration> decode_calibration(SonyPad pad, SonyBus bus,
                                                  std::span<const Byte> report) noexcept;

struct SonySample {
  /// REP-103: x away from the player, y to the left, z up out of the pad's face.
  model::Vec3 rate_deg_s;
  /// Specific force, g: (0, 0, 1) when lying flat.
  model::Vec3 accel_g;
  /// The pad's own clock, microseconds, mod `sony_clock_span_us(pad)`.
  double clock_us = 0.0;
};

/// nullopt for another report: wrong id, length or (Bluetooth) CRC. Without a CRC (USB) any bytes
/// give numbers within the range of the sensors.
std::optional<SonySample> decode_sony(SonyPad pad, std::span<const Byte> report,
                                      const SonyCalibration& calibration) noexcept;

/// Period of the pad's clock, microseconds.
double sony_clock_span_us(SonyPad pad) noexcept;
/// Time between two readings of the pad's clock, s.
double sony_elapsed_s(SonyPad pad, double before_us, double after_us) noexcept;

}  // namespace hedgehog::device
