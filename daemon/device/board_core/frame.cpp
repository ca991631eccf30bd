// SPDX-License-Identifier: MIT
#include "daemon/device/board_core/frame.h"

#include "daemon/device/board_core/crc32.h"

namespace hedgehog::board {
namespace {

constexpr size_t kCrcAt = 60;
constexpr uint8_t kFlagEnable = 1u << 0;
constexpr uint8_t kFlagSwitchClosed = 1u << 0;
constexpr uint8_t kFlagAwake = 1u << 1;
constexpr uint8_t kFlagInLine = 1u << 2;
constexpr int kMinorShift = 4;
constexpr uint8_t kHasSupplyCurrent = 1u << 5;

uint16_t get_u16(const uint8_t* at) noexcept {
  return static_cast<uint16_t>(at[0] | (static_cast<uint16_t>(at[1]) << 8));
}
int16_t get_i16(const uint8_t* at) noexcept { return static_cast<int16_t>(get_u16(at)); }
uint32_t get_u32(const uint8_t* at) noexcept {
  return static_cast<uint32_t>(get_u16(at)) | (static_cast<uint32_t>(get_u16(at + 2)) << 16);
}

void put_u16(uint8_t* at, uint16_t value) noexcept {
  at[0] = static_cast<uint8_t>(value & 0xFFu);
  at[1] = static_cast<uint8_t>(value >> 8);
}
void put_i16(uint8_t* at, int16_t value) noexcept { put_u16(at, static_cast<uint16_t>(value)); }
void put_u32(uint8_t* at, uint32_t value) noexcept {
  put_u16(at, static_cast<uint16_t>(value & 0xFFFFu));
  put_u16(at + 2, static_cast<uint16_t>(value >> 16));
}

void begin(uint8_t* frame, FrameType type, uint8_t flags, uint32_t sequence) noexcept {
  for (size_t i = 0; i < kFrameSize; ++i) frame[i] = 0;
  frame[0] = kFrameMagic;
  frame[1] = kProtocolVersion;
  frame[2] = static_cast<uint8_t>(type);
  frame[3] = flags;
  put_u32(frame + 4, sequence);
}

void finish(uint8_t* frame) noexcept { put_u32(frame + kCrcAt, crc32(frame, kCrcAt)); }

bool is_known(uint8_t type) noexcept {
  switch (static_cast<FrameType>(type)) {
    case FrameType::kSetPoint:
    case FrameType::kArm:
    case FrameType::kLimits:
    case FrameType::kBootLoader:
    case FrameType::kSimulatorError:
    case FrameType::kSimulator:
    case FrameType::kTelemetry:
    case FrameType::kSimulatorTruth:
      return true;
  }
  return false;
}

}  // namespace

FrameError read_header(const uint8_t* bytes, size_t length, FrameHeader& header) noexcept {
  if (length != kFrameSize) return FrameError::kLength;
  if (bytes[0] != kFrameMagic) return FrameError::kMagic;
  if (get_u32(bytes + kCrcAt) != crc32(bytes, kCrcAt)) return FrameError::kCrc;
  if (bytes[1] != kProtocolVersion) return FrameError::kVersion;
  if (!is_known(bytes[2])) return FrameError::kType;
  header.type = static_cast<FrameType>(bytes[2]);
  header.sequence = get_u32(bytes + 4);
  return FrameError::kNone;
}

SetPointFrame read_set_point(const uint8_t* frame) noexcept {
  SetPointFrame values;
  values.sequence = get_u32(frame + 4);
  values.enable = (frame[3] & kFlagEnable) != 0;
  for (size_t k = 0; k < kWindings; ++k) {
    const int16_t duty = get_i16(frame + 8 + 2 * k);
    values.duty_q15[k] = duty == INT16_MIN ? static_cast<int16_t>(-INT16_MAX) : duty;
    values.boost_q15[k] = get_i16(frame + 16 + 2 * k);
  }
  values.fan = frame[14];
  return values;
}

ArmFrame read_arm(const uint8_t* frame) noexcept {
  ArmFrame values;
  values.sequence = get_u32(frame + 4);
  values.count = frame[8];
  return values;
}

LimitsFrame read_limits(const uint8_t* frame) noexcept {
  LimitsFrame values;
  values.sequence = get_u32(frame + 4);
  values.sensor_cc = get_i16(frame + 8);
  values.current_ma = get_u16(frame + 10);
  values.heat_permille = get_u16(frame + 12);
  return values;
}

BootLoaderFrame read_boot_loader(const uint8_t* frame) noexcept {
  BootLoaderFrame values;
  values.sequence = get_u32(frame + 4);
  values.key = get_u32(frame + 8);
  return values;
}

SimulatorFrame read_simulator(const uint8_t* frame) noexcept {
  SimulatorFrame values;
  values.sequence = get_u32(frame + 4);
  values.ambient_cc = get_i16(frame + 8);
  values.faults = get_u16(frame + 10);
  values.coil = frame[12];
  values.errors = frame[13];
  return values;
}

SimulatorErrorFrame read_simulator_error(const uint8_t* frame) noexcept {
  SimulatorErrorFrame values;
  values.sequence = get_u32(frame + 4);
  values.generation = frame[8];
  values.count = frame[9];
  values.index = frame[10];
  values.kind = frame[11];
  values.coil = frame[12];
  values.value_millionths = static_cast<int32_t>(get_u32(frame + 16));
  values.ramp_ms = get_u32(frame + 20);
  return values;
}

SimulatorTruthFrame read_simulator_truth(const uint8_t* frame) noexcept {
  SimulatorTruthFrame values;
  values.sequence = get_u32(frame + 4);
  for (size_t k = 0; k < kWindings; ++k) {
    values.winding_mc[k] = static_cast<int32_t>(get_u32(frame + 8 + 4 * k));
    values.current_ma[k] = static_cast<int32_t>(get_u32(frame + 32 + 4 * k));
  }
  values.core_mc = static_cast<int32_t>(get_u32(frame + 20));
  values.skin_mc = static_cast<int32_t>(get_u32(frame + 24));
  values.ambient_mc = static_cast<int32_t>(get_u32(frame + 28));
  return values;
}

TelemetryFrame read_telemetry(const uint8_t* frame) noexcept {
  TelemetryFrame values;
  values.sequence = get_u32(frame + 4);
  values.received_sequence = get_u32(frame + 8);
  values.set_point_sequence = get_u32(frame + 12);
  values.board_ms = get_u32(frame + 16);
  for (size_t k = 0; k < kWindings; ++k) {
    values.current_ma[k] = get_i16(frame + 20 + 2 * k);
    values.duty_q15[k] = get_i16(frame + 26 + 2 * k);
  }
  values.supply_mv = get_u16(frame + 32);
  values.sensor_cc = get_i16(frame + 34);
  values.fan_rpm = get_u16(frame + 36);
  values.fan = frame[38];
  values.mode = frame[39];
  values.supply_switch_closed = (frame[3] & kFlagSwitchClosed) != 0;
  values.bridges_awake = (frame[3] & kFlagAwake) != 0;
  values.arm_count = frame[40];
  values.sensor_conversions = frame[41];
  values.faults = get_u16(frame + 42);
  values.set_point_age_ms = frame[44];
  values.sensor_limit_cc = get_i16(frame + 46);
  values.current_limit_ma = get_u16(frame + 48);
  values.winding_heat_permille = get_u16(frame + 50);
  values.device_heat_permille = get_u16(frame + 52);
  values.refused = get_u16(frame + 54);
  values.currents_measured = frame[45] & 7u;
  values.currents_in_line = (frame[3] & kFlagInLine) != 0;
  values.minor = static_cast<uint8_t>(frame[3] >> kMinorShift);
  values.thermistors = frame[45] >> 3 & 3u;
  values.supply_current_measured = (frame[45] & kHasSupplyCurrent) != 0;
  values.other_thermistor = static_cast<uint8_t>(frame[45] >> 6);
  values.supply_ma = get_u16(frame + 56);
  values.other_cc = get_i16(frame + 58);
  return values;
}

void write_frame(const SetPointFrame& values, uint8_t* frame) noexcept {
  begin(frame, FrameType::kSetPoint, values.enable ? kFlagEnable : uint8_t{0}, values.sequence);
  for (size_t k = 0; k < kWindings; ++k) {
    put_i16(frame + 8 + 2 * k, values.duty_q15[k]);
    put_i16(frame + 16 + 2 * k, values.boost_q15[k]);
  }
  frame[14] = values.fan;
  finish(frame);
}

void write_frame(const ArmFrame& values, uint8_t* frame) noexcept {
  begin(frame, FrameType::kArm, 0, values.sequence);
  frame[8] = values.count;
  finish(frame);
}

void write_frame(const LimitsFrame& values, uint8_t* frame) noexcept {
  begin(frame, FrameType::kLimits, 0, values.sequence);
  put_i16(frame + 8, values.sensor_cc);
  put_u16(frame + 10, values.current_ma);
  put_u16(frame + 12, values.heat_permille);
  finish(frame);
}

void write_frame(const BootLoaderFrame& values, uint8_t* frame) noexcept {
  begin(frame, FrameType::kBootLoader, 0, values.sequence);
  put_u32(frame + 8, values.key);
  finish(frame);
}

void write_frame(const SimulatorFrame& values, uint8_t* frame) noexcept {
  begin(frame, FrameType::kSimulator, 0, values.sequence);
  put_i16(frame + 8, values.ambient_cc);
  put_u16(frame + 10, values.faults);
  frame[12] = values.coil;
  frame[13] = values.errors;
  finish(frame);
}

void write_frame(const SimulatorErrorFrame& values, uint8_t* frame) noexcept {
  begin(frame, FrameType::kSimulatorError, 0, values.sequence);
  frame[8] = values.generation;
  frame[9] = values.count;
  frame[10] = values.index;
  frame[11] = values.kind;
  frame[12] = values.coil;
  put_u32(frame + 16, static_cast<uint32_t>(values.value_millionths));
  put_u32(frame + 20, values.ramp_ms);
  finish(frame);
}

void write_frame(const SimulatorTruthFrame& values, uint8_t* frame) noexcept {
  begin(frame, FrameType::kSimulatorTruth, 0, values.sequence);
  for (size_t k = 0; k < kWindings; ++k) {
    put_u32(frame + 8 + 4 * k, static_cast<uint32_t>(values.winding_mc[k]));
    put_u32(frame + 32 + 4 * k, static_cast<uint32_t>(values.current_ma[k]));
  }
  put_u32(frame + 20, static_cast<uint32_t>(values.core_mc));
  put_u32(frame + 24, static_cast<uint32_t>(values.skin_mc));
  put_u32(frame + 28, static_cast<uint32_t>(values.ambient_mc));
  finish(frame);
}

void write_frame(const TelemetryFrame& values, uint8_t* frame) noexcept {
  const auto flags = static_cast<uint8_t>((values.supply_switch_closed ? kFlagSwitchClosed : 0) |
                                          (values.bridges_awake ? kFlagAwake : 0) |
                                          (values.currents_in_line ? kFlagInLine : 0) |
                                          (values.minor & 15u) << kMinorShift);
  begin(frame, FrameType::kTelemetry, flags, values.sequence);
  put_u32(frame + 8, values.received_sequence);
  put_u32(frame + 12, values.set_point_sequence);
  put_u32(frame + 16, values.board_ms);
  for (size_t k = 0; k < kWindings; ++k) {
    put_i16(frame + 20 + 2 * k, values.current_ma[k]);
    put_i16(frame + 26 + 2 * k, values.duty_q15[k]);
  }
  put_u16(frame + 32, values.supply_mv);
  put_i16(frame + 34, values.sensor_cc);
  put_u16(frame + 36, values.fan_rpm);
  frame[38] = values.fan;
  frame[39] = values.mode;
  frame[40] = values.arm_count;
  frame[41] = values.sensor_conversions;
  put_u16(frame + 42, values.faults);
  frame[44] = values.set_point_age_ms;
  put_i16(frame + 46, values.sensor_limit_cc);
  put_u16(frame + 48, values.current_limit_ma);
  put_u16(frame + 50, values.winding_heat_permille);
  put_u16(frame + 52, values.device_heat_permille);
  put_u16(frame + 54, values.refused);
  frame[45] =
      static_cast<uint8_t>((values.currents_measured & 7u) | (values.thermistors & 3u) << 3 |
                           (values.supply_current_measured ? kHasSupplyCurrent : 0) |
                           (values.other_thermistor & 3u) << 6);
  put_u16(frame + 56, values.supply_ma);
  put_i16(frame + 58, values.other_cc);
  finish(frame);
}

}  // namespace hedgehog::board
