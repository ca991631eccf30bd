// SPDX-License-Identifier: MIT
// One tick of the ball: sense, check, arbitrate, mix, limit, gate, drive. A function of its inputs
// and state, nothing else; no allocation, lock, log, system call or clock.
#pragma once

#include <type_traits>

#include "daemon/control/checks/estimate_check.h"
#include "daemon/control/checks/fault_debounce.h"
#include "daemon/control/checks/rejected_measurements.h"
#include "daemon/control/checks/telemetry_pair.h"
#include "daemon/control/checks/watchdog.h"
#include "daemon/control/current_prediction.h"
#include "daemon/control/derating.h"
#include "daemon/control/drive.h"
#include "daemon/control/effects/mixer.h"
#include "daemon/control/event_reporter.h"
#include "daemon/control/heading.h"
#include "daemon/control/snapshot.h"
#include "daemon/control/state/control_settings.h"
#include "daemon/control/state/event_list.h"
#include "daemon/control/state/state_machine.h"
#include "daemon/control/step_inputs.h"
#include "daemon/control/winding_visibility.h"
#include "daemon/device/board_io.h"
#include "model/estimate/skin_estimate.h"
#include "model/estimate/thermal_observer.h"
#include "model/limit/thermal_limiter.h"
#include "model/thermal/fan.h"

namespace hedgehog::control {

/// Control thread. Trivially copyable, so that the flight recorder can store it.
class Controller {
 public:
  explicit Controller(const ControlSettings& settings) noexcept;

  /// Advances by one tick and returns the command for the board. `events` is cleared, then filled
  /// with the events of this tick.
  device::BoardCommand step(const StepInputs& inputs, EventList& events) noexcept;

  /// Ends every effect for a clean stop; the daemon sends the safe command afterwards.
  void end_all(EndReason reason, EventList& events) noexcept;

  /// Fills in everything as of the last step except `loop` and `link`.
  void fill(StatusSnapshot& snapshot) const noexcept;

  State state() const noexcept { return states_.state(); }
  Reason reason() const noexcept { return states_.reason(); }
  bool effects_empty() const noexcept { return mixer_.empty(); }
  /// An effect is being derated because the ball is warm.
  bool derating() const noexcept { return derating_.active(); }
  /// The thermal estimate; `hottest_c` is infinite until the first usable reading.
  model::ThermalEstimate thermal() const noexcept;
  const model::LimitedCurrents& passed() const noexcept { return passed_; }
  const Trip& last_trip() const noexcept { return last_trip_; }
  const Watchdog& watchdog() const noexcept { return watchdog_; }

 private:
  // The parts of a step, in its order.

  /// Time since the previous step, s.
  double begin_tick(const StepInputs& inputs, EventList& events) noexcept;
  void sense(const StepInputs& inputs, double dt_s) noexcept;
  /// The reason to trip, or kNone.
  Reason check(const StepInputs& inputs, double dt_s) noexcept;
  /// Updates the state from `found`, the clients' requests and the board.
  void arbitrate(Reason found, const StepInputs& inputs, EventList& events) noexcept;
  void account(const MixResult& mix, const model::CoilCurrents& demand) noexcept;
  void reject_non_finite(double dt_s, EventList& events) noexcept;
  std::uint8_t fan_duty(double dt_s) noexcept;

  void apply_board_limits() noexcept;
  void start_observer(double sensor_c) noexcept;
  /// The reason to trip by the estimate, or kNone.
  Reason update_estimate(double dt_s) noexcept;
  model::ThermalMeasurement measurement() const noexcept;
  double sensor_c() const noexcept;
  double hottest_c() const noexcept;
  /// `thermal()`, in which windings that cannot be measured now count as unmeasured.
  model::ThermalEstimate thermal_as_measured() const noexcept;
  WindingCircuit circuit() const noexcept;
  /// The current of `coil` was measured at both ends of the last millisecond.
  bool is_measured(int coil) const noexcept;
  /// The winding currents, A: those not measured are predicted from the commands.
  model::Vec3 present_a() const noexcept;
  SkinStatus skin() const noexcept;
  void update_state(Reason found, bool present, bool fresh) noexcept;
  void apply_requests(const StepInputs& inputs, EventList& events) noexcept;
  void apply_command(const Command& command, EventList& events) noexcept;
  void on_ball_replaced() noexcept;
  Reason arming_blocker() const noexcept;
  void record_trip(Reason reason) noexcept;
  ReportInputs report_inputs() const noexcept;

  ControlSettings settings_;
  model::Limits limits_;  // of the settings, tightened to the board's
  model::ThermalObserver observer_;
  EstimateCheck estimate_;
  RejectedMeasurements rejected_;
  model::SkinEstimate skin_;
  model::ThermalLimiter limiter_;
  Mixer mixer_;
  Watchdog watchdog_;
  StateMachine states_;
  model::Fan fan_;
  Heading heading_;
  Derating derating_;
  TelemetryPair pair_;
  WindingVisibility visibility_;
  CurrentPrediction prediction_;
  FaultDebounce non_finite_;
  EventReporter reporter_;

  model::Tick now_ = 0;
  bool observing_ = false;  // the observer has its initial values
  std::uint32_t emergency_generation_ = 0;
  std::uint64_t applied_seq_ = 0;
  device::BoardTelemetry board_;
  device::BoardCommand command_;
  model::Vec3 demand_a_;
  model::LimitedCurrents passed_;
  Disagreement disagreement_;
  Trip last_trip_;
};

static_assert(std::is_trivially_copyable_v<Controller>);

}  // namespace hedgehog::control
