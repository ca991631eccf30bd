// SPDX-License-Identifier: MIT
// Frames between host and board: 64 bytes, little endian. Byte tables: ../board-protocol.md.
#pragma once

#include <stddef.h>
#include <stdint.h>

namespace hedgehog::board {

inline constexpr size_t kFrameSize = 64;
inline constexpr uint8_t kFrameMagic = 0x48;
inline constexpr uint8_t kProtocolVersion = 1;  // byte 1; BoardTelemetry::protocol_version
inline constexpr uint8_t kProtocolMinor = 2;    // implemented here
inline constexpr int kWindings = 3;

enum class FrameType : uint8_t {
  kSetPoint = 0x01,
  kArm = 0x02,
  kLimits = 0x03,
  kBootLoader = 0x04,
  kSimulatorError = 0x7E,  // ignored by a real board, like kSimulator
  kSimulator = 0x7F,
  kTelemetry = 0x81,
  kSimulatorTruth = 0xFE,  // simulated board only
};

enum class FrameError : uint8_t { kNone, kLength, kMagic, kCrc, kVersion, kType };

struct FrameHeader {
  FrameType type = FrameType::kSetPoint;
  uint32_t sequence = 0;
};

/// Host to board, every millisecond; the only frame that resets the dead-man.
struct SetPointFrame {
  uint32_t sequence = 0;
  bool enable = false;  // bridges awake; when false the duties are ignored
  /// 1/32767 of the supply, sign = direction. Applied until the next set-point.
  int16_t duty_q15[kWindings] = {};
  int16_t boost_q15[kWindings] = {};  // added to it only in the millisecond of arrival
  uint8_t fan = 0;
};

/// Host to board: clear the latch and arm. Executed once for each new `count`.
struct ArmFrame {
  uint32_t sequence = 0;
  uint8_t count = 0;
};

/// Host to board: tighter limits. Values above those in force have no effect.
struct LimitsFrame {
  uint32_t sequence = 0;
  int16_t sensor_cc = 0;       // hundredths of a degree Celsius
  uint16_t current_ma = 0;     // Euclidean norm
  uint16_t heat_permille = 0;  // of the device's own I^2 t budgets
};

/// Host to board, since 1.2: enter the boot loader, which accepts new firmware. Rejected by a board
/// whose bridges were awake within kBootLoaderMs.
struct BootLoaderFrame {
  static constexpr uint32_t kKey = 0x544F4F42;  // "BOOT"

  uint32_t sequence = 0;
  uint32_t key = kKey;  // any other value is rejected
};

/// Host to simulated board only.
struct SimulatorFrame {
  uint32_t sequence = 0;
  int16_t ambient_cc = 2500;
  uint16_t faults = 0;
  uint8_t coil = 0;
  uint8_t errors = 0;  // number, each in a separate frame; 0 ends the present ones
};

/// Host to simulated board only: error `index` of `count`. Applied when all errors of a new
/// `generation` have arrived.
struct SimulatorErrorFrame {
  uint32_t sequence = 0;
  uint8_t generation = 0;
  uint8_t count = 0;
  uint8_t index = 0;
  uint8_t kind = 0;
  uint8_t coil = 0;
  int32_t value_millionths = 0;
  uint32_t ramp_ms = 0;
};

/// Simulated board to host only: true state of its plant.
struct SimulatorTruthFrame {
  uint32_t sequence = 0;
  int32_t winding_mc[kWindings] = {};  // thousandths of a degree Celsius
  int32_t core_mc = 0;
  int32_t skin_mc = 0;
  int32_t ambient_mc = 0;
  int32_t current_ma[kWindings] = {};
};

/// Board to host, every millisecond.
struct TelemetryFrame {
  uint32_t sequence = 0;
  uint32_t received_sequence = 0;   // of the last accepted frame of any type
  uint32_t set_point_sequence = 0;  // of the last set-point
  uint32_t board_ms = 0;
  int16_t current_ma[kWindings] = {};
  int16_t duty_q15[kWindings] = {};  // at the bridges in the millisecond that ends now
  uint16_t supply_mv = 0;
  int16_t sensor_cc = 0;
  uint16_t fan_rpm = 0;
  uint8_t fan = 0;
  uint8_t mode = 0;
  bool supply_switch_closed = true;
  bool bridges_awake = false;
  uint8_t arm_count = 0;
  uint16_t faults = 0;
  uint8_t sensor_conversions = 0;
  uint8_t set_point_age_ms = 255;      // since the last valid one; 255: 255 or more
  int16_t sensor_limit_cc = 0;         // in force
  uint16_t current_limit_ma = 0;       // in force
  uint16_t winding_heat_permille = 0;  // use of the I^2 t budget, highest of the windings
  uint16_t device_heat_permille = 0;   // and of the whole device
  uint16_t refused = 0;                // rejected frames, mod 65536
  uint8_t minor = 0;                   // since 1.2, 0..15; 0 from older boards
  /// Since 1.1; all 0 from a board of 1.0. Bit k: `current_ma[k]` was measured.
  uint8_t currents_measured = 0;
  uint8_t thermistors = 0;        // 1..3
  bool currents_in_line = false;  // by amplifiers in the windings' leads, with sign, always
  bool supply_current_measured = false;
  uint16_t supply_ma = 0;        // drawn by the bridges
  uint8_t other_thermistor = 0;  // one after the first, in turn: its index, 1 or 2; 0: none
  int16_t other_cc = 0;          // its reading
};

/// `TelemetryFrame::other_cc` when the line of that thermistor is at either rail.
inline constexpr int16_t kOpenCc = INT16_MIN;
inline constexpr int16_t kShortCc = INT16_MAX;

/// Checks length, magic, CRC and version, in this order, then that the type is known.
FrameError read_header(const uint8_t* bytes, size_t length, FrameHeader& header) noexcept;

/// REQUIRES: `read_header` returned no error and this type.
SetPointFrame read_set_point(const uint8_t* frame) noexcept;
ArmFrame read_arm(const uint8_t* frame) noexcept;
LimitsFrame read_limits(const uint8_t* frame) noexcept;
BootLoaderFrame read_boot_loader(const uint8_t* frame) noexcept;
SimulatorFrame read_simulator(const uint8_t* frame) noexcept;
SimulatorErrorFrame read_simulator_error(const uint8_t* frame) noexcept;
SimulatorTruthFrame read_simulator_truth(const uint8_t* frame) noexcept;
TelemetryFrame read_telemetry(const uint8_t* frame) noexcept;

/// Fill all 64 bytes of `frame`, CRC included.
void write_frame(const SetPointFrame& values, uint8_t* frame) noexcept;
void write_frame(const ArmFrame& values, uint8_t* frame) noexcept;
void write_frame(const LimitsFrame& values, uint8_t* frame) noexcept;
void write_frame(const BootLoaderFrame& values, uint8_t* frame) noexcept;
void write_frame(const SimulatorFrame& values, uint8_t* frame) noexcept;
void write_frame(const SimulatorErrorFrame& values, uint8_t* frame) noexcept;
void write_frame(const SimulatorTruthFrame& values, uint8_t* frame) noexcept;
void write_frame(const TelemetryFrame& values, uint8_t* frame) noexcept;

/// True if `sequence` comes after `last`, modulo 2^32.
constexpr bool is_newer(uint32_t sequence, uint32_t last) noexcept {
  return sequence != last && sequence - last < 0x80000000u;
}

}  // namespace hedgehog::board
