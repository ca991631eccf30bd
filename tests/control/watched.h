// SPDX-License-Identifier: MIT
// A watchdog and the board that it watches, in ticks.
#pragma once

#include "daemon/control/checks/watchdog.h"
#include "tests/device/limited.h"

namespace hedgehog::control {

/// A healthy board at rest, one frame per tick, unless a test changes it.
struct Watched {
  device::BoardTelemetry board;
  device::BoardCommand commanded;
  bool present = true;
  bool fresh = true;
  bool armed = true;
  bool arming = false;
  Watchdog watchdog{model::CoilModel{}, model::ThermalModel{}};

  Watched() {
    board.mode = device::BoardMode::kReady;
    board.supply_v = 12.0;
    board.sensor_c = 25.0;
    board.before.known = true;
  }
  Reason step(model::Tick ticks = 1) {
    now_ += ticks;
    if (fresh) {
      ++board.sequence;
      ++board.sensor_conversions;
    }
    pair_.step(fresh, board);
    const Reason reason = watchdog.step({.board_present = present,
                                         .fresh = fresh,
                                         .board = board,
                                         .pair = pair_,
                                         .commanded = commanded,
                                         .ticks = ticks,
                                         .armed = armed,
                                         .arming = arming,
                                         .now = now_,
                                         .thermometer = {}});
    board.before = {true, board.bridges_awake, board.current_a, board.measured};
    return reason;
  }
  Reason run(int ticks) {
    Reason reason = Reason::kNone;
    for (int tick = 0; tick < ticks && reason == Reason::kNone; ++tick) reason = step();
    return reason;
  }

 private:
  TelemetryPair pair_;
  model::Tick now_ = 0;
};

/// A ball whose windings carry `current_a` as commanded, and whose supply shows `share` of what
/// they draw.
inline Watched driven(const model::Vec3& current_a, double share) {
  Watched ball;
  ball.commanded = device::BoardCommand::drive(device::limited(current_a), {0.45, 0.45, 0.45},
                                               1.5e-3, current_a, ball.board.supply_v);
  ball.board.mode = device::BoardMode::kDriving;
  ball.board.bridges_awake = true;
  ball.board.current_a = current_a;
  ball.board.duty = ball.commanded.duty();
  ball.board.accuracy = model::kInLineAccuracy;
  ball.board.supply_current_known = true;
  ball.board.supply_current_a = share * dot(ball.board.duty, current_a);
  return ball;
}

}  // namespace hedgehog::control
