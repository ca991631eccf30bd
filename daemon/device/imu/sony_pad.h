// SPDX-License-Identifier: MIT
// Gyroscope and accelerometer of Sony's DualSense and DualShock 4, by USB and by Bluetooth, with
// the calibration stored in each pad. Source: Linux' hid-playstation.c (reference: hardware.md
// section 5.2): the factory bias is in the maxima of the calibration, but not in the reports. Pure;
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

struct SonyCalibrationReport {  // a feature report
  std::uint8_t id = 0;
  std::size_t bytes = 0;  // including the id
};
SonyCalibrationReport calibration_report(SonyPad pad, SonyBus bus) noexcept;

/// (raw - bias) * scale, in the pad's order x (right), y (up out of its face), z (to the player).
struct SonyCalibration {
  struct Axis {
    double bias = 0.0;
    double scale = 0.0;
  };
  std::array<Axis, 3> gyro;   // deg/s
  std::array<Axis, 3> accel;  // g

  static SonyCalibration nominal() noexcept;  // data sheet: +-2048 deg/s, +-4 g
};

/// nullopt for a wrong id, length or (Bluetooth) CRC. An axis with implausible numbers (a copy of a
/// pad sends zeros) gets its nominal values.
std::optional<SonyCalibration> decode_calibration(SonyPad pad, SonyBus bus,
                                                  std::span<const Byte> report) noexcept;

struct SonySample {
  model::Vec3 rate_deg_s;  // REP-103: x away from the player, y left, z up out of the pad's face
  model::Vec3 accel_g;     // specific force: (0, 0, 1) when lying flat
  double clock_us = 0.0;   // the pad's own clock, mod `sony_clock_span_us(pad)`
};

/// nullopt for another report: wrong id, length or (Bluetooth) CRC. Without a CRC (USB) any bytes
/// give numbers within the range of the sensors.
std::optional<SonySample> decode_sony(SonyPad pad, std::span<const Byte> report,
                                      const SonyCalibration& calibration) noexcept;

double sony_clock_span_us(SonyPad pad) noexcept;  // period of the pad's clock
/// Time between two readings of that clock.
double sony_elapsed_s(SonyPad pad, double before_us, double after_us) noexcept;

}  // namespace hedgehog::device
