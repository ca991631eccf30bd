// SPDX-License-Identifier: MIT
#include "daemon/device/board_core/board_core.h"

namespace hedgehog::board {
namespace {

uint32_t square(int16_t value) noexcept {
  const int32_t wide = value;
  return static_cast<uint32_t>(wide * wide);
}
uint32_t square(uint16_t value) noexcept { return static_cast<uint32_t>(value) * value; }

constexpr int32_t kFullDutyQ15 = 32767;

uint32_t absolute(int16_t value) noexcept {
  const int32_t wide = value;
  return static_cast<uint32_t>(wide < 0 ? -wide : wide);
}

int16_t saturated_sum(int16_t a, int16_t b) noexcept {
  const int32_t sum = int32_t{a} + b;
  if (sum > INT16_MAX) return INT16_MAX;
  if (sum < -INT16_MAX) return -INT16_MAX;
  return static_cast<int16_t>(sum);
}

}  // namespace

void BoardCore::receive(const uint8_t* bytes, size_t length) noexcept {
  FrameHeader header;
  const bool valid = read_header(bytes, length, header) == FrameError::kNone &&
                     header.type != FrameType::kTelemetry &&
                     header.type != FrameType::kSimulatorTruth &&
                     (!any_received_ || is_newer(header.sequence, received_sequence_));
  if (!valid) {
    ++refused_;
    return;
  }
  any_received_ = true;
  received_sequence_ = header.sequence;
  switch (header.type) {
    case FrameType::kSetPoint:
      set_point_ = read_set_point(bytes);
      set_point_new_ = true;
      break;
    case FrameType::kArm:
      arm_requested_ = true;
      requested_arm_count_ = read_arm(bytes).count;
      break;
    case FrameType::kLimits:
      tighten(read_limits(bytes));
      break;
    case FrameType::kBootLoader:
      if (read_boot_loader(bytes).key == BootLoaderFrame::kKey)
        boot_loader_requested_ = true;
      else
        ++refused_;
      break;
    case FrameType::kSimulatorError:
    case FrameType::kSimulator:
    case FrameType::kTelemetry:
    case FrameType::kSimulatorTruth:
      break;
  }
}

void BoardCore::tighten(const LimitsFrame& frame) noexcept {
  if (frame.sensor_cc < limits_.sensor_cc) limits_.sensor_cc = frame.sensor_cc;
  if (frame.current_ma < limits_.current_ma) limits_.current_ma = frame.current_ma;
  const uint32_t winding = full_.winding_a2s * uint32_t{frame.heat_permille} / 1000u;
  const uint32_t device = full_.device_a2s * uint32_t{frame.heat_permille} / 1000u;
  if (winding < limits_.winding_a2s) limits_.winding_a2s = winding;
  if (device < limits_.device_a2s) limits_.device_a2s = device;
}

BoardOutputs BoardCore::step(const BoardInputs& inputs) noexcept {
  ++now_ms_;
  inputs_ = inputs;
  before_ = outputs_;
  if (inputs.thermistors_converted) {
    ++conversions_;
    thermistors_known_ = true;
  }
  age_set_point();
  check_inputs(inputs);
  answer_arm();
  decide();
  answer_boot_loader();
  return outputs_;
}

void BoardCore::age_set_point() noexcept {
  if (set_point_new_)
    set_point_age_ms_ = 0;
  else if (set_point_age_ms_ != UINT32_MAX)
    ++set_point_age_ms_;
  boosting_ = set_point_new_;
  set_point_new_ = false;
}

void BoardCore::check_inputs(const BoardInputs& inputs) noexcept {
  live_ = 0;
  follow_currents(inputs);
  check_current();
  check_sensor(inputs);
  check_supply(inputs);
  if (bridge_.step(inputs.bridge_faults != 0)) live_ |= kBridge;
  latched_ |= live_;
  check_dead_man();
  if (latched_ != 0) mode_ = Mode::kLatched;
}

void BoardCore::follow_currents(const BoardInputs& inputs) noexcept {
  for (int k = 0; k < kWindings; ++k) {
    int16_t& flowing = flowing_ma_[k];
    const bool measured = (inputs.currents_measured >> k & 1u) != 0;
    flowing = measured ? inputs.current_ma[k] : static_cast<int16_t>(flowing - flowing / 4);
    const uint32_t driven =
        absolute(before_.duty_q15[k]) * uint32_t{inputs.supply_mv} / kFullDutyQ15;
    const uint32_t reached = driven * 1000u / limits_.min_resistance_mohm;
    uint32_t& drivable = drivable_ma_[k];
    drivable = drivable > reached
                   ? drivable - (drivable - reached + limits_.decay_ms - 1u) / limits_.decay_ms
                   : reached;
  }
}

void BoardCore::check_current() noexcept {
  uint32_t norm_squared = 0;
  bool budget_spent = false;
  for (int k = 0; k < kWindings; ++k) {
    const uint32_t squared = square(flowing_ma_[k]);
    norm_squared += squared;  // three times 32768^2 still fits
    winding_heat_[k].step(squared);
    budget_spent |= winding_heat_[k].exceeded(limits_.winding_a2s);
  }
  device_heat_.step(norm_squared);
  budget_spent |= device_heat_.exceeded(limits_.device_a2s);

  if (budget_spent) live_ |= kHeatBudget;
  if (over_current_.step(norm_squared > square(limits_.current_ma))) live_ |= kOverCurrent;
  const bool drawn = charged_.step(before_.supply_switch_closed) &&
                     inputs_.supply_current_measured && inputs_.supply_ma > kStuckSupplyMa;
  const bool flows = drawn || norm_squared > kStuckMa * kStuckMa;
  if (stuck_.step(!before_.awake && flows)) live_ |= kStuckBridge;
  if (unexpected_current()) live_ |= kUnexpectedCurrent;
  if (unmeasured_current()) live_ |= kCurrentSense;
}

bool BoardCore::unmeasured_current() noexcept {
  bool found = false;
  for (int k = 0; k < kWindings; ++k) {
    const int16_t duty = before_.duty_q15[k];
    const bool turned = static_cast<int32_t>(duty) * driven_way_[k] < 0;
    const bool blind = before_.awake && !turned && absolute(duty) >= kMinDrivenDutyQ15 &&
                       (inputs_.currents_measured >> k & 1u) == 0;
    unmeasured_ms_[k] = blind ? unmeasured_ms_[k] + 1u : 0u;
    driven_way_[k] = duty < 0 ? int8_t{-1} : int8_t{1};
    found |= unmeasured_ms_[k] >= kUnmeasuredMs;
  }
  return found;
}

bool BoardCore::unexpected_current() noexcept {
  bool beyond = false;
  int32_t drawn_ma = 0;
  for (int k = 0; k < kWindings; ++k) {
    beyond |= absolute(flowing_ma_[k]) > drivable_ma_[k] + kUnexpectedMa;
    drawn_ma += static_cast<int32_t>(before_.duty_q15[k]) * flowing_ma_[k] / kFullDutyQ15;
  }
  // The current returned by braking windings lowers the sum; the shunt does not measure it.
  const auto expected_ma = static_cast<uint32_t>(drawn_ma > 0 ? drawn_ma : 0);
  const bool compared = before_.awake && inputs_.supply_current_measured;
  const bool by_winding = unexpected_.step(before_.awake && beyond);
  const bool by_supply =
      excess_supply_.step(compared ? inputs_.supply_ma : 0u, compared ? expected_ma : 0u);
  return by_winding || by_supply;
}

void BoardCore::check_sensor(const BoardInputs& inputs) noexcept {
  bool open = false;
  bool shorted = false;
  bool hot = false;
  for (int k = 0; k < inputs.thermistors && k < kWindings; ++k) {
    const ThermistorInput& thermistor = inputs.thermistor[k];
    open |= thermistor.open;
    shorted |= thermistor.shorted;
    hot |= !thermistor.open && !thermistor.shorted && thermistor.cc > limits_.sensor_cc;
  }
  if (sensor_open_.step(open)) live_ |= kSensorOpen;
  if (sensor_short_.step(shorted)) live_ |= kSensorShort;
  if (sensor_hot_.step(hot)) live_ |= kOverHeat;
}

void BoardCore::check_supply(const BoardInputs& inputs) noexcept {
  const bool low = inputs.supply_mv < limits_.supply_min_mv;
  const bool high = inputs.supply_mv > limits_.supply_max_mv;
  if (supply_.step(low || high)) live_ |= kSupply;
  if (supply_settled_.step(!low && !high)) supply_usable_ = true;
  if (supply_high_.step(high)) supply_usable_ = false;
}

void BoardCore::check_dead_man() noexcept {
  if (armed() && !fed()) latched_ |= kDeadMan;
}

void BoardCore::answer_arm() noexcept {
  if (!arm_requested_ || requested_arm_count_ == arm_count_) return;
  arm_requested_ = false;
  arm_count_ = requested_arm_count_;
  if (armed() || live_ != 0 || !fed()) return;
  latched_ = 0;
  mode_ = Mode::kReady;
  // A set-point from before the arming must not drive after it.
  set_point_.enable = false;
}

void BoardCore::answer_boot_loader() noexcept {
  boot_loader_due_ = asleep_.step(!outputs_.awake) && boot_loader_requested_;
  if (boot_loader_requested_ && !boot_loader_due_) ++refused_;
  boot_loader_requested_ = false;
}

void BoardCore::decide() noexcept {
  outputs_ = BoardOutputs{};
  if (armed()) {
    mode_ = set_point_.enable ? Mode::kDriving : Mode::kReady;
    if (mode_ == Mode::kDriving) {
      outputs_.awake = true;
      for (int k = 0; k < kWindings; ++k) {
        const int16_t boost = boosting_ ? set_point_.boost_q15[k] : int16_t{0};
        outputs_.duty_q15[k] = saturated_sum(set_point_.duty_q15[k], boost);
      }
    }
  }
  outputs_.supply_switch_closed = supply_usable_ && (latched_ & kStuckBridge) == 0;
  outputs_.fan = fan();
}

uint8_t BoardCore::fan() const noexcept {
  if (mode_ == Mode::kLatched) return 255;
  if (fed()) return set_point_.fan;
  bool cool = thermistors_known_;
  for (int k = 0; k < inputs_.thermistors && k < kWindings; ++k) {
    const ThermistorInput& thermistor = inputs_.thermistor[k];
    cool &= !thermistor.open && !thermistor.shorted && thermistor.cc < kFanFromCc;
  }
  return cool ? 0 : 255;
}

void BoardCore::write_thermistors(TelemetryFrame& out) const noexcept {
  out.thermistors = inputs_.thermistors;
  out.sensor_cc = inputs_.thermistor[0].cc;
  if (inputs_.thermistors < 2) return;
  // The other thermistors take turns of two frames each, so that a host that receives every second
  // frame gets all of them.
  out.other_thermistor = static_cast<uint8_t>(1u + now_ms_ / 2u % (inputs_.thermistors - 1u));
  const ThermistorInput& other = inputs_.thermistor[out.other_thermistor];
  out.other_cc = other.open ? kOpenCc : other.shorted ? kShortCc : other.cc;
}

void BoardCore::write_telemetry(uint8_t* frame) noexcept {
  TelemetryFrame out;
  out.minor = kProtocolMinor;
  out.sequence = ++telemetry_sequence_;
  out.received_sequence = received_sequence_;
  out.set_point_sequence = set_point_.sequence;
  out.board_ms = now_ms_;
  uint16_t fullest = 0;
  for (int k = 0; k < kWindings; ++k) {
    out.current_ma[k] = inputs_.current_ma[k];
    out.duty_q15[k] = before_.duty_q15[k];
    const uint16_t share = winding_heat_[k].permille(limits_.winding_a2s);
    if (share > fullest) fullest = share;
  }
  out.supply_mv = inputs_.supply_mv;
  write_thermistors(out);
  out.currents_measured = inputs_.currents_measured;
  out.currents_in_line = inputs_.currents_in_line;
  out.supply_current_measured = inputs_.supply_current_measured;
  out.supply_ma = inputs_.supply_ma;
  out.fan_rpm = inputs_.fan_rpm;
  out.fan = outputs_.fan;
  out.mode = static_cast<uint8_t>(mode_);
  out.supply_switch_closed = outputs_.supply_switch_closed;
  out.bridges_awake = outputs_.awake;
  out.arm_count = arm_count_;
  out.faults = faults();
  out.sensor_conversions = conversions_;
  out.set_point_age_ms =
      set_point_age_ms_ > 255u ? uint8_t{255} : static_cast<uint8_t>(set_point_age_ms_);
  out.sensor_limit_cc = limits_.sensor_cc;
  out.current_limit_ma = limits_.current_ma;
  out.winding_heat_permille = fullest;
  out.device_heat_permille = device_heat_.permille(limits_.device_a2s);
  out.refused = refused_;
  write_frame(out, frame);
}

}  // namespace hedgehog::board
