// SPDX-License-Identifier: MIT
// One tick of the ball: sense, decide, act. A function of its inputs and state, nothing else; no
// allocation, lock, log, system call or clock (DESIGN section 3, "Pure steps, device time").
#pragma once

#include <type_traits>

#include "daemon/control/checks/estimate_check.h"
#include "daemon/control/checks/fault_debounce.h"
#include "daemon/control/checks/telemetry_pair.h"
#include "daemon/control/checks/watchdog.h"
#include "daemon/control/derating.h"
#include "daemon/control/effects/mixer.h"
#include "daemon/control/heading.h"
#include "daemon/control/snapshot.h"
#include "daemon/control/state/control_settings.h"
#include "daemon/control/state/event_list.h"
#include "daemon/control/state/state_machine.h"
#include "daemon/control/step_inputs.h"
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
  static constexpr double kBlindAfterS = 0.5;
  /// While driven without two frames in a row, or with readings that do not show it, a winding is
  /// not measured by its V/I.
  void track_measuring(double dt_s) noexcept;
  void apply_board_limits() noexcept;
  void start_observer(double sensor_c) noexcept;
  /// The reason to trip by the estimate, or kNone.
  Reason update_estimate(double dt_s) noexcept;
  model::ThermalMeasurement measurement() const noexcept;
  double sensor_c() const noexcept;
  /// Its current was measured at both ends of the last millisecond.
  bool is_measured(int coil) const noexcept;
  /// The windings' currents, A: where they were not measured, those that our commands make flow.
  model::Vec3 present_a() const noexcept;
  SkinStatus skin() const noexcept;
  void update_state(Reason found, bool present, bool fresh) noexcept;
  void apply_command(const Command& command, EventList& events) noexcept;
  void forget_ball() noexcept;
  Reason arming_blocker() const noexcept;
  /// True while an effect plays.
  bool compute_currents(double dt_s, EventList& events) noexcept;
  device::BoardCommand compute_command(bool playing, double dt_s) noexcept;
  void predict_currents() noexcept;
  /// Without new set-points the board holds the last one, until the link makes it safe.
  void advance_skipped_ticks(model::Tick skipped) noexcept;
  void advance_currents(const model::Vec3& voltage, model::Tick ticks) noexcept;
  void record_trip(Reason reason) noexcept;
  void reject_non_finite(double dt_s, EventList& events) noexcept;
  void report(EventType type, EventList& events, std::uint64_t count = 0) const noexcept;
  void report_overrun(std::uint32_t skipped, EventList& events) noexcept;
  struct Reported {
    State state = State::kAbsent;
    Reason reason = Reason::kNoBoard;
    bool attached = false;
    bool oriented = false;
    bool derating = false;
  };
  void report_changes(EventList& events) noexcept;

  ControlSettings settings_;
  model::Limits limits_;  // of the settings, as far as the board allows them
  model::ThermalObserver observer_;
  EstimateCheck estimate_;
  model::SkinEstimate skin_;
  model::ThermalLimiter limiter_;
  Mixer mixer_;
  Watchdog watchdog_;
  StateMachine states_;
  model::Fan fan_;
  Heading heading_;
  Derating derating_;
  TelemetryPair pair_;
  FaultDebounce non_finite_;
  FaultDebounce unpaired_;
  bool blind_ = false;  // so each winding is held to continuous_a
  /// Of each winding: for how long it has been driven without its V/I, so that it is held too.
  std::array<double, model::kCoils> unmeasured_s_{};
  model::Vec3 recent_peak_a_;
  /// For how long the bridges have been asleep.
  double asleep_s_ = 0.0;

  model::Tick now_ = 0;
  bool started_ = false;    // a step has been made
  bool observing_ = false;  // the observer has its start values
  std::uint32_t emergency_generation_ = 0;
  std::uint64_t applied_seq_ = 0;
  device::BoardTelemetry board_;
  device::BoardCommand command_;
  /// What our commands should have made flow, A: for the voltage of the next one.
  model::Vec3 predicted_a_;
  model::Vec3 demand_a_;
  model::LimitedCurrents passed_;
  Disagreement disagreement_;
  Trip last_trip_;
  Reported reported_;  // as of the last events
  model::Tick last_overrun_report_ = -1'000'000;
  std::uint64_t unreported_overruns_ = 0;
  model::Tick last_rejection_report_ = -1'000'000;
};

static_assert(std::is_trivially_copyable_v<Controller>);

}  // namespace hedgehog::control
