// SPDX-License-Identifier: MIT
// A controller and the inputs of its ticks: a healthy board at rest, unless a test changes it.
#pragma once

#include "daemon/control/controller.h"

namespace hedgehog::control {

struct Controlled {
  Controller controller;
  StepInputs inputs;
  EventList events;
  /// The board converts its thermistor.
  bool converting = true;

  explicit Controlled(const ControlSettings& settings) : controller(settings) {
    inputs.board_present = inputs.board_fresh = true;
    inputs.board.mode = device::BoardMode::kReady;
    inputs.board.supply_v = 12.0;
    inputs.board.sensor_c = 25.0;
    inputs.board.before.known = true;
  }
  /// A tick, and `command` in it.
  void step() {
    ++inputs.tick;
    if (inputs.board_fresh) {
      ++inputs.board.sequence;
      if (converting) ++inputs.board.sensor_conversions;
    }
    controller.step(inputs, events);
    inputs.command_count = 0;
    inputs.board.before = {true, inputs.board.bridges_awake, inputs.board.current_a,
                           inputs.board.measured};
  }
  void run(int ticks) {
    for (int tick = 0; tick < ticks; ++tick) step();
  }
  template <class What>
  void command(const What& what) {
    inputs.commands[0] = {1, what};
    inputs.command_count = 1;
    step();
  }
  StatusSnapshot snapshot() const {
    StatusSnapshot snapshot;
    controller.fill(snapshot);
    return snapshot;
  }
};

}  // namespace hedgehog::control
