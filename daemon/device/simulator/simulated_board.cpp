// SPDX-License-Identifier: MIT
#include "daemon/device/simulator/simulated_board.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "model/tick.h"

namespace hedgehog::device {
namespace {

constexpr double kStuckDuty = 0.1;
constexpr double kWeakestShare = 0.8;  // as in board_core/limits.h
constexpr double kJumpK = 15.0;
constexpr double kOffsetKPerS = -0.5;
constexpr double kLowSupplyV = 5.0;
constexpr int kRippleMs = 10;

template <class Integer>
Integer reading(double value) noexcept {
  constexpr double kLow = std::numeric_limits<Integer>::min();
  constexpr double kHigh = std::numeric_limits<Integer>::max();
  return static_cast<Integer>(std::lround(std::clamp(value, kLow, kHigh)));
}

/// A firmware is built for one kind of ball: the simulated one.
board::BoardLimits limits_for(const model::PlantParameters& plant) noexcept {
  board::BoardLimits limits;
  const double weakest_ohm = *std::min_element(plant.r25_ohm.begin(), plant.r25_ohm.end());
  const double min_ohm = kWeakestShare * weakest_ohm;
  limits.min_resistance_mohm = std::max<std::uint16_t>(1, reading<std::uint16_t>(1000.0 * min_ohm));
  limits.decay_ms = std::max<std::uint16_t>(
      1, reading<std::uint16_t>(std::ceil(1000.0 * plant.inductance_h / min_ohm)));
  return limits;
}

/// Its kind, before its check sum is known to be right.
bool is_for_simulator(std::span<const std::uint8_t> packet) noexcept {
  if (packet.size() != board::kFrameSize) return false;
  const auto type = static_cast<board::FrameType>(packet[2]);
  return type == board::FrameType::kSimulator || type == board::FrameType::kSimulatorError;
}

}  // namespace

SimulatedBoard::SimulatedBoard(const SimulatedBoardOptions& options) noexcept
    : plant_(options.plant, options.ambient_c),
      full_limits_(limits_for(options.plant)),
      core_(full_limits_),
      built_(options.front_end.parameters()),
      front_end_(built_, options.plant.seed),
      nominal_supply_v_(options.plant.supply_v) {
  const double start = options.start_c;
  plant_.set_heat({{start, start, start}, start});
  settings_.ambient_c = options.ambient_c;
  for (int k = 0; k < model::kCoils; ++k) show(k, start);
}

void SimulatedBoard::receive(std::span<const std::uint8_t> packet) noexcept {
  board::FrameHeader header;
  if (is_for_simulator(packet) &&
      board::read_header(packet.data(), packet.size(), header) == board::FrameError::kNone) {
    const auto frame = packet.first<board::kFrameSize>();
    if (header.type == board::FrameType::kSimulator) {
      SimulatorSettings settings = decode_simulator(frame);
      if (board::read_simulator(frame.data()).errors != 0) settings.errors = errors_.list();
      apply(settings);
      return;
    }
    if (header.type == board::FrameType::kSimulatorError) {
      if (const auto errors = error_reader_.take(frame)) set_errors(*errors);
      return;
    }
  }
  // An unplugged cable blocks both directions; only the simulator's settings are still applied.
  if (!has(kSimSilent) && boot_loader_ms_ == 0) core_.receive(packet.data(), packet.size());
}

void SimulatedBoard::apply(const SimulatorSettings& settings) noexcept {
  const bool errors_differ = settings.errors != errors_.list();
  settings_ = settings;
  plant_.set_ambient(settings.ambient_c);
  if (!has(kSimSensorOffset)) offset_k_ = 0.0;
  if (errors_differ) errors_.set(settings.errors);
  act_errors();
}

void SimulatedBoard::set_errors(const SimulatorErrorList& errors) noexcept {
  SimulatorSettings settings = settings_;
  settings.errors = errors;
  apply(settings);
}

void SimulatedBoard::act_errors() noexcept {
  plant_.set_errors(errors_.plant());
  front_end_.parameters() = errors_.on(built_);
  if (has(kSimCurrentSense)) front_end_.parameters().current_gain[settings_.coil] *= 0.5;
}

board::BoardOutputs SimulatedBoard::step_core() noexcept {
  const board::BoardInputs inputs = measure();
  if (boot_loader_ms_ > 0) {
    // State of the pins after a reset.
    board::BoardOutputs undriven;
    undriven.supply_switch_closed = false;
    undriven.fan = 255;
    if (--boot_loader_ms_ == 0) core_ = board::BoardCore(full_limits_);
    return undriven;
  }
  const board::BoardOutputs outputs = core_.step(inputs);
  if (core_.boot_loader_due()) boot_loader_ms_ = kBootLoaderMs;
  return outputs;
}

std::optional<Frame> SimulatedBoard::step() noexcept {
  const board::BoardOutputs outputs = step_core();
  Frame frame;
  core_.write_telemetry(frame.data());
  if (errors_.step()) act_errors();
  step_plant(outputs);
  if (has(kSimSilent) || boot_loader_ms_ > 0) return std::nullopt;
  return frame;
}

const board::RawInputs& SimulatedBoard::step_electronics(
    const board::BoardOutputs& outputs) noexcept {
  if (errors_.step()) act_errors();
  step_plant(outputs);
  convert();
  return raw_;
}

std::optional<Frame> SimulatedBoard::truth_frame() const noexcept {
  const std::uint32_t now = core_.now_ms();
  if (now % kConversionMs != 0 || boot_loader_ms_ > 0) return std::nullopt;
  return truth(now);
}

Frame SimulatedBoard::truth(std::uint32_t now_ms) const noexcept {
  PlantTruth truth;
  truth.coils_c = plant_.heat().winding_c;
  truth.core_c = plant_.heat().core_c;
  truth.skin_c = plant_.skin_c();
  truth.ambient_c = plant_.ambient_c();
  truth.current_a = plant_.current_a();
  return encode_truth(truth, now_ms);
}

Analogue SimulatedBoard::analogue() const noexcept {
  Analogue analogue;
  analogue.before_a = before_a_;
  analogue.after_a = plant_.current_a();
  analogue.duty = driven_duty_;
  analogue.awake = driven_awake_;
  analogue.supply_v = plant_.parameters().supply_v;
  for (int coil = 0; coil < model::kCoils; ++coil)
    analogue.thermistor_c[static_cast<std::size_t>(coil)] = plant_.thermistor_c(coil);
  analogue.thermistor_noise_k = plant_.parameters().sensor_noise_k;
  analogue.fan_rpm = errors_.tach_gain() * plant_.fan_rpm();
  return analogue;
}

board::BoardInputs SimulatedBoard::measure() noexcept {
  const Analogue now = convert();
  if (built_.kind == FrontEndKind::kIdeal) return measure_exactly(now);
  return board::measured(built_.wiring, raw_, core_.outputs(), core_.last_inputs());
}

Analogue SimulatedBoard::convert() noexcept {
  const Analogue now = analogue();
  if (has(kSimSensorOffset)) offset_k_ += kOffsetKPerS * model::kTickSeconds;
  raw_.ntc_converted = false;
  if (--until_conversion_ <= 0 && !has(kSimSensorStale)) {
    until_conversion_ = kConversionMs;
    raw_.ntc_converted = true;
    convert_thermistors(now);
  }
  raw_.faults_low =
      has(kSimBridgeFault) ? static_cast<std::uint8_t>(1u << settings_.coil) : std::uint8_t{0};
  if (built_.kind == FrontEndKind::kIdeal) return now;
  front_end_.convert(now, raw_);
  wire_thermistors();
  return now;
}

int SimulatedBoard::broken_thermistor() const noexcept {
  return built_.wiring.thermistors > 1 ? settings_.coil : 0;
}

int SimulatedBoard::winding_under(int thermistor) const noexcept {
  return built_.wiring.thermistors > 1 ? thermistor : plant_.parameters().sensor_winding;
}

void SimulatedBoard::convert_thermistors(const Analogue& analogue) noexcept {
  for (int k = 0; k < built_.wiring.thermistors; ++k) {
    const bool broken = k == broken_thermistor();
    if (broken && has(kSimSensorFrozen)) continue;
    double celsius = front_end_.thermistor_c(analogue, winding_under(k));
    if (broken) celsius += offset_k_ + (has(kSimSensorJump) ? kJumpK : 0.0);
    show(k, celsius);
  }
}

void SimulatedBoard::show(int thermistor, double celsius) noexcept {
  const auto i = static_cast<std::size_t>(thermistor);
  shown_c_[i] = celsius;
  shown_adc_[i] = front_end_.ntc_adc(celsius);
}

void SimulatedBoard::wire_thermistors() noexcept {
  for (int k = 0; k < built_.wiring.thermistors; ++k)
    raw_.ntc_adc[k] = shown_adc_[static_cast<std::size_t>(k)];
  std::uint16_t& broken = raw_.ntc_adc[broken_thermistor()];
  if (has(kSimSensorOpen)) broken = built_.wiring.adc_full;
  if (has(kSimSensorShort)) broken = 0;
}

board::BoardInputs SimulatedBoard::measure_exactly(const Analogue& analogue) noexcept {
  const FrontEndParameters& errors = front_end_.parameters();
  board::BoardInputs inputs;
  for (int k = 0; k < model::kCoils; ++k) {
    const auto i = static_cast<std::size_t>(k);
    inputs.current_ma[k] = reading<std::int16_t>(
        1000.0 * (errors.current_gain[i] * analogue.after_a[k] + errors.current_offset_a[i]));
  }
  inputs.supply_mv = reading<std::uint16_t>(1000.0 * errors.supply_gain * analogue.supply_v);
  inputs.currents_in_line = true;
  inputs.supply_current_measured = true;
  inputs.supply_ma = reading<std::uint16_t>(1000.0 * FrontEnd::drawn_a(analogue));
  inputs.fan_rpm = reading<std::uint16_t>(analogue.fan_rpm);
  inputs.bridge_faults = raw_.faults_low;
  inputs.thermistors = built_.wiring.thermistors;
  inputs.thermistors_converted = raw_.ntc_converted;
  for (int k = 0; k < inputs.thermistors; ++k) {
    board::ThermistorInput& thermistor = inputs.thermistor[k];
    const bool broken = k == broken_thermistor();
    thermistor.open = broken && has(kSimSensorOpen);
    thermistor.shorted = broken && has(kSimSensorShort);
    // Values of the thermistor curve for a line at either rail.
    const double shown = thermistor.open      ? -300.0
                         : thermistor.shorted ? 300.0
                                              : shown_c_[static_cast<std::size_t>(k)];
    thermistor.cc = reading<std::int16_t>(100.0 * shown);
  }
  return inputs;
}

void SimulatedBoard::step_plant(const board::BoardOutputs& outputs) noexcept {
  const FrontEndParameters& electronics = front_end_.parameters();
  supply_ms_ = (supply_ms_ + 1) % kRippleMs;
  const double ripple = std::sin(2.0 * std::numbers::pi * supply_ms_ / kRippleMs);
  const double supply_v = has(kSimSupplyLow)
                              ? kLowSupplyV
                              : nominal_supply_v_ -
                                    electronics.source_ohm * FrontEnd::drawn_a(analogue()) +
                                    electronics.ripple_v * ripple;
  plant_.set_supply(supply_v);
  model::PlantInputs inputs;
  inputs.fan_duty = outputs.fan / 255.0;
  inputs.fan_stopped = has(kSimFanStopped);
  driven_duty_ = {};
  for (int k = 0; k < model::kCoils; ++k) {
    const auto i = static_cast<std::size_t>(k);
    model::BridgeState& bridge = inputs.bridge[i];
    double duty = 0.0;
    if (outputs.awake) {
      bridge = model::BridgeState::kDriven;
      // With a stuck PWM line SLP still disables the bridge.
      duty = errors_.stuck_duty(k).value_or(outputs.duty_q15[k] / kFullDuty);
    }
    // A bridge that signals a fault has switched itself off.
    if (touches(kSimBridgeFault, k)) bridge = model::BridgeState::kAsleep;
    if (touches(kSimStuckBridge, k)) {
      bridge = model::BridgeState::kDriven;
      duty = kStuckDuty;
    }
    if (!outputs.supply_switch_closed) bridge = model::BridgeState::kAsleep;
    if (touches(kSimOpenWinding, k)) bridge = model::BridgeState::kOpen;
    if (bridge == model::BridgeState::kDriven) driven_duty_[k] = duty;
    inputs.voltage_v[k] = duty * supply_v;
  }
  driven_awake_ = outputs.awake || has(kSimStuckBridge);
  before_a_ = plant_.current_a();
  plant_.step(inputs, model::kTickSeconds);
}

}  // namespace hedgehog::device
