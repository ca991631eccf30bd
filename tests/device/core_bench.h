// SPDX-License-Identifier: MIT
// A board core under test: healthy measurements unless a test changes them, and a host side that
// numbers its frames.
#pragma once

#include <array>
#include <cstdint>

#include "daemon/device/board_core/board_core.h"

namespace hedgehog::board {

struct CoreBench {
  BoardCore core;
  BoardInputs inputs;
  BoardOutputs outputs;
  std::uint32_t sequence = 0;
  std::uint8_t arm_count = 0;
  /// True: `run` sends a set-point before each step.
  bool feeding = true;
  SetPointFrame set_point;

  explicit CoreBench(const BoardLimits& limits = {}) : core(limits) {
    inputs.supply_mv = 12000;
    inputs.thermistor[0].cc = 2500;
    inputs.thermistors_converted = true;
    set_point.enable = true;
    set_point.duty_q15[0] = 8000;
  }

  template <class Values>
  void send(Values values) {
    std::array<std::uint8_t, kFrameSize> frame;
    values.sequence = ++sequence;
    write_frame(values, frame.data());
    core.receive(frame.data(), frame.size());
  }
  void feed() { send(set_point); }
  void request_arm() {
    ArmFrame arm;
    arm.count = ++arm_count;
    send(arm);
  }
  void step() { outputs = core.step(inputs); }

  void run(int ms) {
    for (int i = 0; i < ms; ++i) {
      if (feeding) feed();
      step();
    }
  }
  /// Set-points, an arm request, and one more set-point: driving from here on.
  void arm_and_drive() {
    feed();
    request_arm();
    step();
    run(1);
  }

  bool drives() const {
    return outputs.awake || outputs.duty_q15[0] != 0 || outputs.duty_q15[1] != 0 ||
           outputs.duty_q15[2] != 0;
  }
  bool has(Fault fault) const { return (core.faults() & fault) != 0; }
  /// Latched for this reason, bridges asleep, duty 0, fan full.
  bool latched_by(Fault fault) const {
    return core.mode() == Mode::kLatched && has(fault) && !drives() && outputs.fan == 255;
  }
  TelemetryFrame telemetry() {
    std::array<std::uint8_t, kFrameSize> frame;
    core.write_telemetry(frame.data());
    return read_telemetry(frame.data());
  }
};

}  // namespace hedgehog::board
