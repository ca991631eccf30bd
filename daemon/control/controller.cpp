// SPDX-License-Identifier: MIT
#include "daemon/control/controller.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "model/limit/rearm.h"
#include "model/limit/shell_limit.h"
#include "model/tick.h"

namespace hedgehog::control {
namespace {

using model::kTickSeconds;
using model::Tick;
using model::Vec3;

// The link makes the board safe after 20 ms without a set-point, so no more than that was heated.
constexpr Tick kLongestGap = 20;
// How often the same complaint is worth an event.
constexpr Tick kReportEvery = model::kTicksPerSecond;
constexpr double kNonFiniteHoldS = 0.05;

}  // namespace

Controller::Controller(const ControlSettings& settings) noexcept
    : settings_(settings),
      limits_(settings.limits),
      observer_(settings.coils, settings.thermal, {}),
      skin_(settings.thermal),
      limiter_(settings.limits),
      watchdog_(settings.coils, settings.thermal, settings.thermometer),
      states_(settings) {}

device::BoardCommand Controller::step(const StepInputs& inputs, EventList& events) noexcept {
  events.clear();
  now_ = inputs.tick;
  const Tick ticks = 1 + static_cast<Tick>(inputs.skipped);
  const double dt_s = kTickSeconds * static_cast<double>(std::min(ticks, kLongestGap));
  report_overrun(inputs.skipped, events);

  advance_skipped_ticks(inputs.skipped);
  const Reason found = sense(inputs, dt_s);
  update_state(found, inputs.board_present, inputs.board_fresh);

  const bool emergency = inputs.emergency_generation != emergency_generation_;
  emergency_generation_ = inputs.emergency_generation;
  for (int i = 0; i < inputs.stop_count; ++i)
    mixer_.stop(inputs.stops[static_cast<std::size_t>(i)], now_, events);
  for (int i = 0; i < inputs.command_count; ++i)
    apply_command(inputs.commands[static_cast<std::size_t>(i)], events);
  // After the commands, so that no arming of the same tick survives it.
  if (emergency) states_.emergency_stop(now_);

  const State before = states_.state();
  states_.step(board_, inputs.board_fresh, arming_blocker(), now_);
  if (states_.state() != before) {
    if (states_.armed()) watchdog_.begin_armed();
    // A board that does not give up its latch.
    if (states_.state() == State::kTripped) record_trip(states_.reason());
  }

  const bool playing = compute_currents(dt_s, events);
  command_ = compute_command(playing, dt_s);
  predict_currents();
  report_changes(events);
  started_ = true;
  return command_;
}

Reason Controller::sense(const StepInputs& inputs, double dt_s) noexcept {
  if (inputs.board_fresh) {
    board_ = inputs.board;
    apply_board_limits();
  }
  pair_.step(inputs.board_fresh, inputs.board);
  const Reason found =
      watchdog_.step({inputs.board_present, inputs.board_fresh, board_, pair_, command_,
                      limits_.trip_c, 1 + static_cast<Tick>(inputs.skipped), states_.armed(),
                      states_.arming(), now_, inputs.thermometer});
  track_measuring(dt_s);
  heading_.step(inputs.orientation, now_);
  const Reason estimated = update_estimate(dt_s);
  if (found == Reason::kMeasurementsDisagree)
    disagreement_ = watchdog_.disagreement();
  else if (estimated == Reason::kMeasurementsDisagree)
    disagreement_ = estimate_.disagreement();
  return found != Reason::kNone ? found : estimated;
}

void Controller::update_state(Reason found, bool present, bool fresh) noexcept {
  const BoardCheck& board = watchdog_.board();
  if (!board.alive()) {
    const bool silent = !present || fresh ? board.age() >= BoardCheck::kSilence / 2 : true;
    const Reason gone = silent ? Reason::kTelemetryLost : Reason::kNoBoard;
    if (states_.armed()) record_trip(gone);
    states_.board_gone(gone, now_);
    return;
  }
  states_.board_alive(board_, now_);
  if (found != Reason::kNone) {
    if (states_.state() != State::kTripped) record_trip(found);
    states_.trip(found, now_);
  } else if (board.restarted()) {
    states_.board_restarted(now_);
  }
}

void Controller::apply_command(const Command& command, EventList& events) noexcept {
  applied_seq_ = command.seq;
  if (const auto* start = std::get_if<StartEffect>(&command.what)) {
    mixer_.start(*start, command.seq, now_, events);
  } else if (const auto* update = std::get_if<UpdateEffect>(&command.what)) {
    mixer_.update(*update, now_);
  } else if (const auto* frames = std::get_if<LoadKeyframes>(&command.what)) {
    mixer_.load(*frames);
  } else if (const auto* arm = std::get_if<Arm>(&command.what)) {
    if (arm->generation == emergency_generation_) states_.arm(arming_blocker(), now_);
  } else if (const auto* recenter = std::get_if<Recenter>(&command.what)) {
    heading_.recenter(recenter->azimuth_deg);
  } else if (const auto* gain = std::get_if<SetGain>(&command.what)) {
    if (gain->gain >= 0.0 && gain->gain <= 1.0) settings_.gain = gain->gain;
  } else if (const auto* limits = std::get_if<SetLimits>(&command.what)) {
    if (is_within(limits->limits, settings_.ceiling)) {
      settings_.limits = limits->limits;
      apply_board_limits();
    }
  } else if (std::holds_alternative<ForgetBall>(command.what)) {
    forget_ball();
  }
}

Reason Controller::arming_blocker() const noexcept {
  const Reason arming_blocker = watchdog_.arming_blocker();
  if (arming_blocker != Reason::kNone) return arming_blocker;
  // A board's latch for heat may be older than this daemon.
  constexpr std::uint16_t kByHeat = device::kFaultOverHeat | device::kFaultHeatBudget;
  const auto board_heat = static_cast<std::uint16_t>(board_.faults & kByHeat);
  const Reason why = board_heat != 0 ? reason_of_faults(board_heat) : states_.reason();
  // What is forgotten may have been a trip by heat.
  const bool by_heat = why == Reason::kOverheated || why == Reason::kBoardOverHeat ||
                       why == Reason::kBoardHeatBudget || why == Reason::kStateLost;
  const model::ThermalEstimate& thermal = observer_.estimate();
  const double cool_c = model::rearm_below_c(limits_, thermal.ambient_c);
  if (by_heat && !(thermal.hottest_c < cool_c)) return why;
  if (states_.reason() == Reason::kShellHot && watchdog_.thermometer().too_warm_to_arm())
    return Reason::kShellHot;
  const FanCheck& fan = watchdog_.fan();
  if (fan.stopped() || (states_.reason() == Reason::kFanStopped && fan.standing()))
    return Reason::kFanStopped;
  return states_.rearm_wait(now_) > 0 ? states_.latch() : Reason::kNone;
}

bool Controller::compute_currents(double dt_s, EventList& events) noexcept {
  const MixResult mix = mixer_.mix(
      {now_, states_.armed(), heading_.fresh(), heading_.device_to_world(), settings_.gain},
      events);
  const Vec3 wanted = currents_for(mix.field, settings_.coils).a + mix.coil_a;
  demand_a_ = mix.field.a + field_of({mix.coil_a}, settings_.coils).a;
  model::ThermalEstimate thermal = this->thermal();
  for (std::size_t i = 0; i < model::kCoils; ++i)
    if (blind_ || unmeasured_s_[i] > kBlindAfterS) thermal.measured[i] = false;
  limiter_.set_ceiling(model::shell_allowed_current(limits_, skin().bound_c));
  passed_ = limiter_.limit({wanted}, thermal, dt_s);
  if (!states_.armed()) passed_ = model::LimitedCurrents();  // the watchdog's gate

  const double asked_a = norm(wanted);
  mixer_.account(asked_a > 0.0 ? norm(passed_.a()) / asked_a : 1.0);
  derating_.step(mix.any ? std::min(asked_a, limits_.current_a) : 0.0, limiter_.allowed().value,
                 now_);
  reject_non_finite(dt_s, events);
  return mix.playing;
}

void Controller::reject_non_finite(double dt_s, EventList& events) noexcept {
  const bool rejected = limiter_.rejected();
  if (rejected) demand_a_ = {};
  if (rejected && now_ - last_rejection_report_ >= kReportEvery) {
    last_rejection_report_ = now_;
    report(EventType::kRejectedNumber, events);
  }
  if (non_finite_.step(rejected, dt_s, kNonFiniteHoldS) && states_.armed()) {
    record_trip(Reason::kInternal);
    states_.trip(Reason::kInternal, now_);
  }
}

device::BoardCommand Controller::compute_command(bool playing, double dt_s) noexcept {
  device::BoardCommand command;
  // While no effect plays the bridges sleep: duty 0 alone would be a brake that keeps them awake.
  if (states_.armed() && playing) {
    command =
        device::BoardCommand::drive(passed_, observer_.estimate().resistance_ohm,
                                    settings_.coils.inductance_h, predicted_a_, board_.supply_v);
  }
  command.fan = fan_.step(thermal().hottest_c, norm(present_a()), dt_s);
  if (states_.state() == State::kTripped) command.fan = 255;
  command.arm_count = states_.arm_count();
  return command;
}

void Controller::predict_currents() noexcept {
  advance_currents(board_.supply_v * command_.first_duty(), 1);
}

void Controller::advance_skipped_ticks(Tick skipped) noexcept {
  if (skipped == 0) return;
  const Tick held = std::min(skipped, kLongestGap - 1);
  advance_currents(board_.supply_v * command_.duty(), held);
  // Asleep since then. The diodes end the current sooner than this, so no boost gets too large.
  advance_currents({}, skipped - held);
}

void Controller::advance_currents(const Vec3& voltage, Tick ticks) noexcept {
  for (int coil = 0; coil < model::kCoils; ++coil) {
    const double r = observer_.estimate().resistance_ohm[static_cast<std::size_t>(coil)];
    const double goal = voltage[coil] / r;
    const double keep =
        std::exp(-r * kTickSeconds * static_cast<double>(ticks) / settings_.coils.inductance_h);
    predicted_a_[coil] = goal + keep * (predicted_a_[coil] - goal);
  }
}

void Controller::record_trip(Reason reason) noexcept {
  last_trip_ = {reason, now_, thermal().hottest_c, norm(pair_.after_a()), {}};
  if (reason == Reason::kMeasurementsDisagree) last_trip_.disagreement = disagreement_;
}

}  // namespace hedgehog::control
