// SPDX-License-Identifier: MIT
// The payloads of an Xsens MTi that are used here: MTData2, a list of (id u16, length u8, data),
// and the output configuration, a list of (id u16, rate u16). Big endian. Source: as xbus.h. Pure.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "daemon/device/byte_order.h"
#include "model/quaternion.h"
#include "model/vec3.h"

namespace hedgehog::device {

/// Data ids without their low nibble (number format, frame).
enum class MtDataId : std::uint16_t {
  kPacketCounter = 0x1020,
  kSampleTimeFine = 0x1060,
  kQuaternion = 0x2010,
  kEulerAngles = 0x2030,
  kAcceleration = 0x4020,
  kRateOfTurn = 0x8020,
  kRateOfTurnHr = 0x8040,
  kStatusWord = 0xE020,
};

/// One MTData2 message. Fields that are absent, or have an invalid length or number, are missing.
struct MtSample {
  std::optional<std::uint16_t> packet_counter;
  std::optional<std::uint32_t> sample_time;  // ticks of 0.1 ms; wraps
  /// Sensor -> world with z up (ENU or NWU; NED is converted). Unit length.
  std::optional<model::Quaternion> quaternion;
  std::optional<model::Vec3> euler_deg;  // roll, pitch, yaw
  std::optional<model::Vec3> acceleration_m_s2;
  std::optional<model::Vec3> rate_rad_s;
  std::optional<std::uint32_t> status;
};

/// nullopt if the list does not fill the payload exactly. Unknown ids are skipped.
std::optional<MtSample> decode_mtdata2(std::span<const Byte> payload);

struct MtOutput {
  std::uint16_t id = 0;
  std::uint16_t rate_hz = 0;  // 0xFFFF: with every packet
  friend bool operator==(const MtOutput&, const MtOutput&) = default;
};

/// Output configuration for an MTi: counter and time, quaternion and rate of turn at `rate_hz`,
/// status. No magnetometer: the ball contains a magnet.
std::vector<MtOutput> orientation_outputs(std::uint16_t rate_hz);

std::vector<Byte> encode_outputs(std::span<const MtOutput> outputs);
/// nullopt if the length is not a multiple of 4.
std::optional<std::vector<MtOutput>> decode_outputs(std::span<const Byte> payload);

}  // namespace hedgehog::device
