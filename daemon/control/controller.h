// SPDX-License-Identifier: MIT
// One tick of the ball: sense, decide, act. A function of its inputs and state, nothing else; no
// allocation, lock, log, system call or clock (DESIGN section 3, "Pure steps, device time").
#pragma once

#include <type_traits>

#include "daemon/control/control_settings.h"
#include "daemon/control/debounce.h"
#include "daemon/control/derating.h"
#include "daemon/control/event_list.h"
#include "daemon/control/fan.h"
#include "daemon/control/heading.h"
#include "daemon/control/mixer.h"
#include "daemon/control/snapshot.h"
#include "daemon/control/state_machine.h"
#include "daemon/control/step_inputs.h"
#include "daemon/control/telemetry_pair.h"
#include "daemon/control/watchdog.h"
#include "daemon/device/board_io.h"
#include "model/thermal_limiter.h"
#include "model/thermal_observer.h"

namespace hedgehog::control {

/// Control thread. Trivially copyable, so that the flight recorder can store it.
class Controller {
 public:
  explicit Controller(const ControlSettings& settings) noexcept;

  /// The next tick: what to send to the board. `events` is emptied and then has what happened.
  device::BoardCommand step(const StepInputs& inputs, EventList& events) noexcept;

  /// Ends every effect; for a clean stop. The daemon sends the safe command after it.
  void end_all(EndReason reason, EventList& events) noexcept;

  /// Everything as of the last step; `loop` and `link` are left alone.
  void fill(StatusSnapshot& snapshot) const noexcept;

  State state() const noexcept { return states_.state(); }
  Reason reason() const noexcept { return states_.reason(); }
  bool effects_empty() const noexcept { return mixer_.empty(); }
  /// An effect is being reduced because the ball is warm.
  bool derating() const noexcept { return derating_.active(); }
  /// What is known: until the first usable reading nothing, so `hottest_c` is infinite.
  model::ThermalEstimate thermal() const noexcept;
  const model::LimitedCurrents& passed() const noexcept { return passed_; }
  const Trip& last_trip() const noexcept { return last_trip_; }
  const Watchdog& watchdog() const noexcept { return watchdog_; }

 private:
  Reason sense(const StepInputs& inputs, double dt_s) noexcept;
  /// While driven without two frames in a row no winding is measured by its V/I.
  void watch_measuring(double dt_s) noexcept;
  void keep_limits() noexcept;
  void start_observer(double sensor_c) noexcept;
  void observe(double dt_s) noexcept;
  void follow_board(Reason found, bool present, bool fresh) noexcept;
  void take(const Command& command, EventList& events) noexcept;
  Reason arm_refusal() const noexcept;
  /// True while an effect plays.
  bool push(double dt_s, EventList& events) noexcept;
  device::BoardCommand drive(bool playing, double dt_s) noexcept;
  void predict_flow() noexcept;
  /// Without new set-points the board holds the last one, until the link makes it safe.
  void hold_flow(model::Tick skipped) noexcept;
  void let_flow(const model::Vec3& voltage, model::Tick ticks) noexcept;
  void note_trip(Reason reason) noexcept;
  void reject(double dt_s, EventList& events) noexcept;
  void say(EventType type, EventList& events, std::uint64_t count = 0) const noexcept;
  void say_overrun(std::uint32_t skipped, EventList& events) noexcept;
  struct Said {
    State state = State::kAbsent;
    Reason reason = Reason::kNoBoard;
    bool attached = false;
    bool oriented = false;
    bool derating = false;
  };
  void say_changes(EventList& events) noexcept;

  ControlSettings settings_;
  model::Limits limits_;  // of the settings, as far as the board allows them
  model::ThermalObserver observer_;
  model::ThermalLimiter limiter_;
  Mixer mixer_;
  Watchdog watchdog_;
  StateMachine states_;
  Fan fan_;
  Heading heading_;
  Derating derating_;
  TelemetryPair pair_;
  Debounce absurd_;
  Debounce unpaired_;
  bool blind_ = false;  // so each winding is held to continuous_a

  model::Tick now_ = 0;
  bool started_ = false;    // a step has been made
  bool observing_ = false;  // the observer has its start values
  std::uint32_t emergency_generation_ = 0;
  std::uint64_t applied_seq_ = 0;
  device::BoardTelemetry board_;
  device::BoardCommand command_;
  /// What our commands should have made flow, A: for the voltage of the next one.
  model::Vec3 flowing_a_;
  model::Vec3 demand_a_;
  model::LimitedCurrents passed_;
  Trip last_trip_;
  Said said_;  // what events have told so far
  model::Tick overrun_said_ = -1'000'000;
  std::uint64_t overrun_unsaid_ = 0;
  model::Tick rejected_said_ = -1'000'000;
};

static_assert(std::is_trivially_copyable_v<Controller>);

}  // namespace hedgehog::control
