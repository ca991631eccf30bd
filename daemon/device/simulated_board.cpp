// SPDX-License-Identifier: MIT
#include "daemon/device/simulated_board.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "model/tick.h"

namespace hedgehog::device {
namespace {

constexpr double kStuckDuty = 0.1;
constexpr double kJumpK = 15.0;
constexpr double kOffsetKPerS = -0.5;
constexpr double kLowSupplyV = 5.0;

template <class Integer>
Integer reading(double value) noexcept {
  constexpr double kLow = std::numeric_limits<Integer>::min();
  constexpr double kHigh = std::numeric_limits<Integer>::max();
  return static_cast<Integer>(std::lround(std::clamp(value, kLow, kHigh)));
}

}  // namespace

SimulatedBoard::SimulatedBoard(const SimulatedBoardOptions& options) noexcept
    : plant_(options.plant, options.ambient_c), nominal_supply_v_(options.plant.supply_v) {
  const double start = options.start_c;
  plant_.set_heat({{start, start, start}, start});
  settings_.ambient_c = options.ambient_c;
  reading_c_ = start;
}

void SimulatedBoard::receive(std::span<const std::uint8_t> packet) noexcept {
  board::FrameHeader header;
  if (board::read_header(packet.data(), packet.size(), header) == board::FrameError::kNone &&
      header.type == board::FrameType::kSimulator) {
    apply(decode_simulator(packet.first<board::kFrameSize>()));
    return;
  }
  // A pulled cable is pulled in both directions; only the tester's wishes still get through.
  if (!has(kSimSilent)) core_.receive(packet.data(), packet.size());
}

void SimulatedBoard::apply(const SimulatorSettings& settings) noexcept {
  settings_ = settings;
  plant_.set_room(settings.ambient_c);
  plant_.set_supply(has(kSimSupplyLow) ? kLowSupplyV : nominal_supply_v_);
  if (!has(kSimSensorOffset)) offset_k_ = 0.0;
}

std::optional<Frame> SimulatedBoard::step() noexcept {
  const board::BoardOutputs outputs = core_.step(measure());
  Frame frame;
  core_.write_telemetry(frame.data());
  run_world(outputs);
  if (has(kSimSilent)) return std::nullopt;
  return frame;
}

board::BoardInputs SimulatedBoard::measure() noexcept {
  board::BoardInputs inputs;
  for (int k = 0; k < model::kCoils; ++k) {
    const double half = has(kSimCurrentSense) && settings_.coil == k ? 0.5 : 1.0;
    inputs.current_ma[k] = reading<std::int16_t>(1000.0 * half * plant_.current_a()[k]);
  }
  inputs.supply_mv = reading<std::uint16_t>(1000.0 * plant_.parameters().supply_v);
  inputs.fan_rpm = reading<std::uint16_t>(plant_.fan_rpm());
  if (has(kSimBridgeFault)) inputs.bridge_faults = static_cast<std::uint8_t>(1u << settings_.coil);
  convert_sensor(inputs);
  return inputs;
}

void SimulatedBoard::convert_sensor(board::BoardInputs& inputs) noexcept {
  if (has(kSimSensorOffset)) offset_k_ += kOffsetKPerS * model::kTickSeconds;
  if (--until_conversion_ <= 0 && !has(kSimSensorStale)) {
    until_conversion_ = kConversionMs;
    inputs.sensor_converted = true;
    if (!has(kSimSensorFrozen))
      reading_c_ = plant_.sensor_c() + offset_k_ + (has(kSimSensorJump) ? kJumpK : 0.0);
  }
  inputs.sensor_open = has(kSimSensorOpen);
  inputs.sensor_short = has(kSimSensorShort);
  // What a thermistor's curve makes of a line at either rail.
  const double shown = inputs.sensor_open ? -300.0 : inputs.sensor_short ? 300.0 : reading_c_;
  inputs.sensor_cc = reading<std::int16_t>(100.0 * shown);
}

void SimulatedBoard::run_world(const board::BoardOutputs& outputs) noexcept {
  const double supply_v = plant_.parameters().supply_v;
  model::PlantInputs inputs;
  inputs.fan_duty = outputs.fan / 255.0;
  inputs.fan_stopped = has(kSimFanStopped);
  for (int k = 0; k < model::kCoils; ++k) {
    const auto i = static_cast<std::size_t>(k);
    const bool touched = settings_.coil == k;
    model::BridgeState& bridge = inputs.bridge[i];
    if (outputs.awake) {
      bridge = model::BridgeState::kDriven;
      inputs.voltage_v[k] = supply_v * outputs.duty_q15[k] / kFullDuty;
    }
    // A bridge that signals a fault has switched itself off.
    if (touched && has(kSimBridgeFault)) bridge = model::BridgeState::kAsleep;
    if (touched && has(kSimStuckBridge)) {
      bridge = model::BridgeState::kDriven;
      inputs.voltage_v[k] = kStuckDuty * supply_v;
    }
    if (!outputs.supply_switch_closed) bridge = model::BridgeState::kAsleep;
    if (touched && has(kSimOpenWinding)) bridge = model::BridgeState::kOpen;
  }
  plant_.step(inputs, model::kTickSeconds);
}

}  // namespace hedgehog::device
