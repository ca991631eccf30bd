// SPDX-License-Identifier: MIT
// All inputs of one tick of the controller. One trivially copyable value: the flight recorder
// stores it, and the same values from the same state give the same outputs bit for bit.
#pragma once

#include <array>
#include <cstdint>
#include <type_traits>

#include "daemon/control/effects/command.h"
#include "daemon/control/state/event.h"
#include "daemon/device/board_io.h"
#include "daemon/device/orientation.h"
#include "daemon/device/thermometer/sample.h"
#include "model/tick.h"

namespace hedgehog::control {

/// Request to end an effect: by its owner (kStopped), or its connection closed (kDisconnected).
struct StopRequest {
  EffectId effect = 0;
  std::uint8_t place = 0;
  EndReason reason = EndReason::kStopped;
};

/// The part of fixed size; a recording contains all of it.
struct TickInputs {
  model::Tick tick = 0;
  std::uint32_t skipped = 0;  // ticks between the last step and this one (the thread was late)
  std::uint32_t emergency_generation = 0;  // a change signals device.emergency_stop

  bool board_present = false;
  bool board_fresh = false;  // `board` is new in this tick
  device::BoardTelemetry board;
  device::OrientationSample orientation;
  device::ThermometerSample thermometer;

  std::uint16_t stop_count = 0;
  std::uint16_t command_count = 0;
};

struct StepInputs : TickInputs {
  std::array<StopRequest, kEffectPlaces> stops{};
  std::array<Command, kMaxCommandsPerTick> commands{};
};

static_assert(std::is_trivially_copyable_v<StepInputs>);

}  // namespace hedgehog::control
