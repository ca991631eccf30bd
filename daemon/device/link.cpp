// SPDX-License-Identifier: MIT
#include "daemon/device/link.h"

#include <algorithm>

namespace hedgehog::device {
namespace {

constexpr int kArmTicks = 50;
// A frame may be lost, and the board may require its bridges to have slept for longer.
constexpr int kBootLoaderTicks = 50;
// The board's clock wraps every 49.7 days; a larger step back is a restart.
constexpr std::uint32_t kLongestGapMs = 10'000;
// Frames with lasting settings are repeated, in case one was lost.
constexpr int kLimitsEveryTicks = 1000;
constexpr int kSimulatorEveryTicks = 100;
constexpr std::uint32_t kThermistorFrames = 100;

}  // namespace

void Link::receive(std::span<const std::uint8_t> packet) noexcept {
  const DecodedTelemetry decoded = decode_telemetry(packet);
  if (decoded.error == board::FrameError::kNone) {
    accept_telemetry(decoded.telemetry);
    return;
  }
  if (const auto truth = decode_truth(packet)) {
    truth_ = *truth;
    return;
  }
  ++report_.counters.errors;
  if (decoded.error == board::FrameError::kVersion) ticks_without_telemetry_ = kAbsentTicks;
}

void Link::accept_telemetry(BoardTelemetry telemetry) noexcept {
  const BoardTelemetry& last = report_.telemetry;
  if (telemetry_received_) {
    // After 2^31 frames a restarted board would count as newer by the number alone.
    const bool clock_reset =
        telemetry.board_ms < last.board_ms && telemetry.board_ms - last.board_ms > kLongestGapMs;
    const bool newer = !clock_reset && board::is_newer(telemetry.sequence, last.sequence);
    // A board that was absent meanwhile needs neither: it may be another board, or have restarted.
    const bool absent = ticks_without_telemetry_ >= kAbsentTicks;
    const bool restarted = clock_reset || (absent && !newer);
    if (!newer && !restarted) {
      ++report_.counters.errors;
      return;
    }
    if (newer && !absent) report_.counters.lost += telemetry.sequence - last.sequence - 1;
    if (newer && telemetry.sequence == last.sequence + 1)
      telemetry.before = {true, last.bridges_awake, last.current_a, last.measured};
    // A restarted board must not be armed by an earlier request.
    if (restarted) {
      arm_ticks_left_ = 0;
      limits_due_ticks_ = 0;
      arm_offset_ = static_cast<std::uint8_t>(last.arm_count - telemetry.arm_count);
    }
  }
  merge_thermistors(telemetry);
  telemetry_received_ = true;
  telemetry.arm_count = static_cast<std::uint8_t>(telemetry.arm_count + arm_offset_);
  ticks_without_telemetry_ = 0;
  ++report_.counters.frames_in;
  ++report_.telemetry_count;

  // The board has received frames of another host: continue from its number, or it rejects new
  // frames as stale. A board that has received none reports 0.
  if (telemetry.received_sequence != 0 && board::is_newer(telemetry.received_sequence, sequence_))
    sequence_ = telemetry.received_sequence;

  if (telemetry.arm_count == requested_arm_) arm_ticks_left_ = 0;
  report_.telemetry = telemetry;
}

// The thermistors after the first take turns; one without a reading for long is unknown.
void Link::merge_thermistors(BoardTelemetry& telemetry) noexcept {
  const bool absent = ticks_without_telemetry_ >= kAbsentTicks;
  for (std::size_t k = 1; k < telemetry.thermistor.size(); ++k) {
    std::uint32_t& age = thermistor_age_[k];
    if (telemetry.thermistor[k].state != ThermistorState::kNone) {
      age = 0;
      continue;
    }
    age = absent ? kThermistorFrames : std::min(age + 1, kThermistorFrames);
    const bool fitted = k < static_cast<std::size_t>(telemetry.thermistors);
    if (fitted && age < kThermistorFrames)
      telemetry.thermistor[k] = report_.telemetry.thermistor[k];
  }
}

void Link::set_simulator(const SimulatorSettings& simulator) noexcept {
  if (simulator_ != simulator) {
    simulator_due_ticks_ = 0;
    simulator_part_ = 0;
  }
  simulator_ = simulator;
}

void Link::skip(std::uint64_t ticks) noexcept {
  // No count here is larger.
  const auto passed = static_cast<int>(std::min<std::uint64_t>(ticks, kLimitsEveryTicks));
  ticks_without_telemetry_ = std::min(ticks_without_telemetry_ + passed, kAbsentTicks);
  ticks_without_command_ = std::min(ticks_without_command_ + passed, kOverdueTicks);
  for (int* left :
       {&arm_ticks_left_, &boot_loader_ticks_left_, &limits_due_ticks_, &simulator_due_ticks_})
    *left = std::max(*left - passed, 0);
}

LinkFrames Link::step(LinkPort& port) noexcept {
  const BoardLimits& limits = port.limits.read();
  if (port.limits.was_fresh()) set_limits(limits);
  const SimulatorSettings& simulator = port.simulator.read();
  if (port.simulator.was_fresh()) set_simulator(simulator);
  return step(port.commands.read());
}

LinkFrames Link::step(const LinkCommand& command) noexcept {
  update_presence();
  const BoardCommand chosen = choose(command);
  update_arm(command.board.arm_count);
  update_boot_loader(command.board.boot_loader_count);

  LinkFrames frames;
  frames.set_point = encode_set_point(chosen, ++sequence_);
  frames.other = next_other();
  report_.counters.frames_out += frames.other ? 2 : 1;
  skip(1);
  return frames;
}

void Link::set_written(std::int64_t now_ns) noexcept {
  if (overdue_ || !report_.present || report_.written_count == last_count_) return;
  report_.written_count = last_count_;
  report_.written_ns = now_ns;
}

void Link::update_presence() noexcept {
  const bool present = ticks_without_telemetry_ < kAbsentTicks;
  if (present && !report_.present) limits_due_ticks_ = 0;
  if (!present) arm_ticks_left_ = boot_loader_ticks_left_ = 0;
  report_.present = present;
}

BoardCommand Link::choose(const LinkCommand& command) noexcept {
  const bool fresh = command.count != last_count_;
  if (fresh) {
    last_count_ = command.count;
    ticks_without_command_ = 0;
  }
  const bool overdue = ticks_without_command_ >= kOverdueTicks;
  if (overdue && !overdue_) ++report_.counters.overdue;
  overdue_ = overdue;
  if (!overdue && report_.present) return fresh ? command.board : command.board.held();

  BoardCommand safe;
  const bool control_is_stuck = overdue && last_count_ != 0;
  safe.fan = control_is_stuck ? std::uint8_t{255} : command.board.fan;
  return safe;
}

void Link::update_arm(std::uint8_t wanted) noexcept {
  if (wanted == requested_arm_) return;
  requested_arm_ = wanted;
  const bool is_request = report_.present && wanted != report_.telemetry.arm_count;
  arm_ticks_left_ = is_request ? kArmTicks : 0;
}

void Link::update_boot_loader(std::uint8_t wanted) noexcept {
  if (wanted == requested_boot_loader_) return;
  requested_boot_loader_ = wanted;
  boot_loader_ticks_left_ = report_.present ? kBootLoaderTicks : 0;
}

std::optional<Frame> Link::next_other() noexcept {
  if (arm_ticks_left_ > 0)
    return encode_arm(static_cast<std::uint8_t>(requested_arm_ - arm_offset_), ++sequence_);
  if (boot_loader_ticks_left_ > 0) return encode_boot_loader(++sequence_);
  if (limits_ && report_.present && limits_due_ticks_ == 0) {
    limits_due_ticks_ = kLimitsEveryTicks;
    return encode_limits(*limits_, ++sequence_);
  }
  if (simulator_ && simulator_due_ticks_ == 0) return next_simulator();
  return std::nullopt;
}

Frame Link::next_simulator() noexcept {
  const int part = simulator_part_++;
  if (simulator_part_ > simulator_->errors.count) {
    simulator_part_ = 0;
    simulator_due_ticks_ = kSimulatorEveryTicks;
  }
  if (part == 0) return encode_simulator(*simulator_, ++sequence_);
  return encode_simulator_error(simulator_->errors, static_cast<std::uint8_t>(part - 1),
                                ++sequence_);
}

}  // namespace hedgehog::device
