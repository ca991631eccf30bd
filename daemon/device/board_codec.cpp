// SPDX-License-Identifier: MIT
#include "daemon/device/board_codec.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "daemon/device/board_core/frame.h"

namespace hedgehog::device {
namespace {

template <class Integer>
Integer rounded(double value) noexcept {
  constexpr double kLow = std::numeric_limits<Integer>::min();
  constexpr double kHigh = std::numeric_limits<Integer>::max();
  // NaN is converted to the minimum, which is the tightest value of a limit.
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

Frame encode_boot_loader(std::uint32_t sequence) noexcept {
  board::BootLoaderFrame values;
  values.sequence = sequence;
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
  values.errors = settings.errors.count;
  return written(values);
}

namespace {

Thermistor thermistor_of(std::int16_t cc) noexcept {
  if (cc == board::kOpenCc) return {ThermistorState::kOpen, 0.0};
  if (cc == board::kShortCc) return {ThermistorState::kShorted, 0.0};
  return {ThermistorState::kRead, cc / 100.0};
}

void decode_validity(const board::TelemetryFrame& values, BoardTelemetry& out) noexcept {
  const bool has_validity = values.thermistors != 0;
  out.protocol_minor = values.minor != 0 ? values.minor : has_validity ? 1 : 0;
  for (std::size_t k = 0; k < board::kWindings; ++k) {
    // A board of protocol 1.0 measures a current only while driving the winding, or when it is
    // larger than this.
    constexpr int kShownMa = 500;
    const bool shows = values.duty_q15[k] != 0 || std::abs(values.current_ma[k]) > kShownMa;
    out.measured[k] = has_validity ? (values.currents_measured >> k & 1u) != 0 : shows;
  }
  out.accuracy = values.currents_in_line ? model::kInLineAccuracy : model::kDriverCsAccuracy;
  out.supply_current_known = has_validity && values.supply_current_measured;
  out.supply_current_a = out.supply_current_known ? values.supply_ma / 1000.0 : 0.0;
  out.thermistors = has_validity ? values.thermistors : 1;
  out.thermistor[0] = {ThermistorState::kRead, values.sensor_cc / 100.0};
  const std::size_t other = values.other_thermistor;
  if (other != 0 && other < out.thermistor.size())
    out.thermistor[other] = thermistor_of(values.other_cc);
}

}  // namespace

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
  decode_validity(values, out);
  out.supply_v = values.supply_mv / 1000.0;
  out.sensor_c = values.sensor_cc / 100.0;
  out.fan_rpm = values.fan_rpm;
  out.fan_duty = values.fan / 255.0;
  // An unknown mode is treated as not driving.
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

Frame encode_simulator_error(const SimulatorErrorList& list, std::uint8_t index,
                             std::uint32_t sequence) noexcept {
  board::SimulatorErrorFrame values;
  values.sequence = sequence;
  values.generation = list.generation;
  values.count = list.count;
  values.index = index;
  const SimulatorError& error = list.error[index];
  values.kind = static_cast<std::uint8_t>(error.kind);
  values.coil = error.coil;
  values.value_millionths = rounded<std::int32_t>(1e6 * error.value);
  values.ramp_ms = rounded<std::uint32_t>(1e3 * error.ramp_s);
  return written(values);
}

std::optional<SimulatorErrorList> SimulatorErrorReader::take(
    std::span<const std::uint8_t, board::kFrameSize> frame) noexcept {
  const board::SimulatorErrorFrame values = board::read_simulator_error(frame.data());
  if (values.count > SimulatorErrorList::kMaxErrors || values.index >= values.count)
    return std::nullopt;
  if (values.kind >= kSimulatorErrorKinds) return std::nullopt;
  const bool same = values.generation == list_.generation && values.count == list_.count;
  if (!begun_ || !same) {
    begun_ = true;
    list_ = {};
    list_.generation = values.generation;
    list_.count = values.count;
    arrived_ = 0;
    taken_ = false;
  }
  const auto kind = static_cast<SimulatorErrorKind>(values.kind);
  const SimulatorErrorRange range = range_of(kind);
  list_.error[values.index] = {kind, std::min<std::uint8_t>(values.coil, model::kCoils - 1),
                               std::clamp(values.value_millionths / 1e6, range.min, range.max),
                               values.ramp_ms / 1000.0};
  arrived_ |= std::uint64_t{1} << values.index;
  const std::uint64_t all = (std::uint64_t{1} << values.count) - 1;
  if (taken_ || arrived_ != all) return std::nullopt;
  taken_ = true;
  return list_;
}

std::optional<PlantTruth> decode_truth(std::span<const std::uint8_t> packet) noexcept {
  board::FrameHeader header;
  const bool truth =
      board::read_header(packet.data(), packet.size(), header) == board::FrameError::kNone &&
      header.type == board::FrameType::kSimulatorTruth;
  if (!truth) return std::nullopt;
  const board::SimulatorTruthFrame values = board::read_simulator_truth(packet.data());
  PlantTruth out;
  out.known = true;
  for (int k = 0; k < model::kCoils; ++k) {
    out.coils_c[static_cast<std::size_t>(k)] = values.winding_mc[k] / 1000.0;
    out.current_a[k] = values.current_ma[k] / 1000.0;
  }
  out.core_c = values.core_mc / 1000.0;
  out.skin_c = values.skin_mc / 1000.0;
  out.ambient_c = values.ambient_mc / 1000.0;
  return out;
}

Frame encode_truth(const PlantTruth& truth, std::uint32_t sequence) noexcept {
  board::SimulatorTruthFrame values;
  values.sequence = sequence;
  for (int k = 0; k < model::kCoils; ++k) {
    values.winding_mc[k] =
        rounded<std::int32_t>(1000.0 * truth.coils_c[static_cast<std::size_t>(k)]);
    values.current_ma[k] = rounded<std::int32_t>(1000.0 * truth.current_a[k]);
  }
  values.core_mc = rounded<std::int32_t>(1000.0 * truth.core_c);
  values.skin_mc = rounded<std::int32_t>(1000.0 * truth.skin_c);
  values.ambient_mc = rounded<std::int32_t>(1000.0 * truth.ambient_c);
  return written(values);
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
