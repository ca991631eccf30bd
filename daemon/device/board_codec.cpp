// SPDX-License-Identifier: MIT
#include "daemon/device/board_codec.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "daemon/device/board_core/board_core.h"

namespace hedgehog::device {
namespace {

template <class A, class B>
constexpr bool same(A a, B b) noexcept {
  return static_cast<int>(a) == static_cast<int>(b);
}
static_assert(same(kFaultDeadMan, board::kDeadMan) &&
              same(kFaultOverCurrent, board::kOverCurrent) &&
              same(kFaultOverHeat, board::kOverHeat) &&
              same(kFaultHeatBudget, board::kHeatBudget) && same(kFaultBridge, board::kBridge) &&
              same(kFaultSensorOpen, board::kSensorOpen) &&
              same(kFaultSensorShort, board::kSensorShort) &&
              same(kFaultStuckBridge, board::kStuckBridge) && same(kFaultSupply, board::kSupply));
static_assert(same(BoardMode::kSafe, board::Mode::kSafe) &&
              same(BoardMode::kReady, board::Mode::kReady) &&
              same(BoardMode::kDriving, board::Mode::kDriving) &&
              same(BoardMode::kLatched, board::Mode::kLatched));

template <class Integer>
Integer rounded(double value) noexcept {
  constexpr double kLow = std::numeric_limits<Integer>::min();
  constexpr double kHigh = std::numeric_limits<Integer>::max();
  // Not a number becomes the lowest value: for a limit that is the tightest.
  if (!(value > kLow)) return std::numeric_limits<Integer>::min();
  return static_cast<Integer>(std::lround(std::min(value, kHigh)));
}

template <class Values>
Frame written(const Values& values) noexcept {
  Frame frame;
  board::write_frame(values, frame.data());
  return frame;
}

}  // namespace

Frame encode_set_point(const BoardCommand& command, std::uint32_t sequence) noexcept {
  board::SetPointFrame values;
  values.sequence = sequence;
  values.enable = command.enable();
  std::copy(command.duty_q15().begin(), command.duty_q15().end(), values.duty_q15);
  std::copy(command.boost_q15().begin(), command.boost_q15().end(), values.boost_q15);
  values.fan = command.fan;
  return written(values);
}

Frame encode_arm(std::uint8_t count, std::uint32_t sequence) noexcept {
  board::ArmFrame values;
  values.sequence = sequence;
  values.count = count;
  return written(values);
}

BoardLimits BoardLimits::of(const model::Limits& limits) noexcept {
  BoardLimits board;
  board.sensor_c = std::min(board.sensor_c, limits.trip_c + 5.0);
  board.current_a = std::min(board.current_a, 1.1 * limits.current_a);
  return board;
}

Frame encode_limits(const BoardLimits& limits, std::uint32_t sequence) noexcept {
  board::LimitsFrame values;
  values.sequence = sequence;
  values.sensor_cc = rounded<std::int16_t>(100.0 * limits.sensor_c);
  values.current_ma = rounded<std::uint16_t>(1000.0 * limits.current_a);
  values.heat_permille = rounded<std::uint16_t>(1000.0 * limits.heat);
  return written(values);
}

Frame encode_simulator(const SimulatorSettings& settings, std::uint32_t sequence) noexcept {
  board::SimulatorFrame values;
  values.sequence = sequence;
  values.ambient_cc = rounded<std::int16_t>(100.0 * settings.ambient_c);
  values.faults = settings.faults;
  values.coil = settings.coil;
  return written(values);
}

DecodedTelemetry decode_telemetry(std::span<const std::uint8_t> packet) noexcept {
  DecodedTelemetry decoded;
  board::FrameHeader header;
  decoded.error = board::read_header(packet.data(), packet.size(), header);
  if (decoded.error != board::FrameError::kNone) return decoded;
  if (header.type != board::FrameType::kTelemetry) {
    decoded.error = board::FrameError::kType;
    return decoded;
  }
  const board::TelemetryFrame values = board::read_telemetry(packet.data());
  BoardTelemetry& out = decoded.telemetry;
  out.sequence = values.sequence;
  out.received_sequence = values.received_sequence;
  out.set_point_sequence = values.set_point_sequence;
  out.board_ms = values.board_ms;
  for (int k = 0; k < board::kWindings; ++k) {
    out.current_a[k] = values.current_ma[k] / 1000.0;
    out.duty[k] = values.duty_q15[k] / kFullDuty;
  }
  out.supply_v = values.supply_mv / 1000.0;
  out.sensor_c = values.sensor_cc / 100.0;
  out.fan_rpm = values.fan_rpm;
  out.fan_duty = values.fan / 255.0;
  // A mode that we do not know is not one that drives.
  out.mode = values.mode <= static_cast<std::uint8_t>(BoardMode::kLatched)
                 ? static_cast<BoardMode>(values.mode)
                 : BoardMode::kLatched;
  out.supply_switch_closed = values.supply_switch_closed;
  out.bridges_awake = values.bridges_awake;
  out.arm_count = values.arm_count;
  out.faults = values.faults;
  out.sensor_conversions = values.sensor_conversions;
  out.protocol_version = board::kProtocolVersion;
  out.limit_sensor_c = values.sensor_limit_cc / 100.0;
  out.limit_current_a = values.current_limit_ma / 1000.0;
  out.heat_used = std::max(values.winding_heat_permille, values.device_heat_permille) / 1000.0;
  return decoded;
}

SimulatorSettings decode_simulator(
    std::span<const std::uint8_t, board::kFrameSize> frame) noexcept {
  const board::SimulatorFrame values = board::read_simulator(frame.data());
  SimulatorSettings settings;
  settings.ambient_c = values.ambient_cc / 100.0;
  settings.faults = values.faults;
  settings.coil = std::min<std::uint8_t>(values.coil, model::kCoils - 1);
  return settings;
}

}  // namespace hedgehog::device
