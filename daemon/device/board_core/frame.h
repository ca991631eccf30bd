// SPDX-License-Identifier: MIT
// Frames between host and board: 64 bytes, little endian, the same code on both sides. Byte tables:
// ../board-protocol.md.
#pragma once

#include <stddef.h>
#include <stdint.h>

namespace hedgehog::board {

inline constexpr size_t kFrameSize = 64;
inline constexpr uint8_t kFrameMagic = 0x48;
/// Byte 1 of every frame; also the value of BoardTelemetry::protocol_version.
inline constexpr uint8_t kProtocolVersion = 1;
/// Minor version implemented here.
inline constexpr uint8_t kProtocolMinor = 2;
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

/// Reason for rejecting a frame.
enum class FrameError : uint8_t { kNone, kLength, kMagic, kCrc, kVersion, kType };

struct FrameHeader {
  FrameType type = FrameType::kSetPoint;
  uint32_t sequence = 0;
};

/// Host to board, every millisecond; the only frame that resets the dead-man.
struct SetPointFrame {
  uint32_t sequence = 0;
  /// Bridges awake. When false the duties are ignored.
  bool enable = false;
  /// 1/32767 of the supply, sign = direction. Applied until the next set-point.
  int16_t duty_q15[kWindings] = {};
  /// Added to it only in the millisecond in which this frame arrived.
  int16_t boost_q15[kWindings] = {};
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
/// whose bridges are awake, or were within kBootLoaderMs.
struct BootLoaderFrame {
  static constexpr uint32_t kKey = 0x544F4F42;  // "BOOT"

  uint32_t sequence = 0;
  /// Any other value is rejected.
  uint32_t key = kKey;
};

/// Host to simulated board only.
struct SimulatorFrame {
  uint32_t sequence = 0;
  int16_t ambient_cc = 2500;
  uint16_t faults = 0;
  uint8_t coil = 0;
  /// Number of errors that belong to these settings, each in a separate frame; 0 ends the present
  /// ones.
  uint8_t errors = 0;
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
  /// Of the last accepted frame of any type, and of the last set-point.
  uint32_t received_sequence = 0;
  uint32_t set_point_sequence = 0;
  uint32_t board_ms = 0;
  int16_t current_ma[kWindings] = {};
  /// Duties applied at the bridges during the millisecond that ends now.
  int16_t duty_q15[kWindings] = {};
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
  /// Since the last valid set-point, ms; 255 means 255 or more.
  uint8_t set_point_age_ms = 255;
  /// The limits in force, and the use of the I^2 t budgets: the highest of the windings, and the
  /// whole device.
  int16_t sensor_limit_cc = 0;
  uint16_t current_limit_ma = 0;
  uint16_t winding_heat_permille = 0;
  uint16_t device_heat_permille = 0;
  /// Number of rejected frames, mod 65536.
  uint16_t refused = 0;
  /// Since 1.2, 0..15; 0 from older boards.
  uint8_t minor = 0;
  /// Since 1.1; all 0 from a board of 1.0. Bit k: `current_ma[k]` was measured.
  uint8_t currents_measured = 0;
  /// Number of thermistors, 1..3.
  uint8_t thermistors = 0;
  /// Measured by amplifiers in the windings' leads, with sign, in every bridge state.
  bool currents_in_line = false;
  bool supply_current_measured = false;
  /// Current drawn by the bridges.
  uint16_t supply_ma = 0;
  /// The thermistors after the first, one per frame in turn: its index (1, 2; 0: none) and its
  /// reading.
  uint8_t other_thermistor = 0;
  int16_t other_cc = 0;
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
