// SPDX-License-Identifier: MIT
#include "daemon/control/controller.h"

#include <algorithm>

#include "model/limit/rearm.h"
#include "model/tick.h"

namespace hedgehog::control {
namespace {

using model::Tick;

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
  const double dt_s = begin_tick(inputs, events);
  sense(inputs, dt_s);
  const Reason found = check(inputs, dt_s);
  arbitrate(found, inputs, events);

  const MixResult mix = mixer_.mix(
      {now_, states_.armed(), heading_.fresh(), heading_.device_to_world(), settings_.gain},
      events);
  const model::CoilCurrents demand = demanded_currents(mix, settings_.coils);
  const model::LimitedCurrents limited =
      limit(limiter_, demand, thermal_as_measured(), skin().bound_c, dt_s);
  passed_ = gate(limited, states_.armed());
  account(mix, demand);
  reject_non_finite(dt_s, events);

  command_ = drive(passed_, states_.armed() && mix.playing, prediction_.a(), circuit());
  command_.fan = fan_duty(dt_s);
  command_.arm_count = states_.arm_count();
  command_.boot_loader_count = states_.boot_loader_count();
  prediction_.predict_currents(command_, circuit());
  reporter_.report_changes(report_inputs(), events);
  return command_;
}

double Controller::begin_tick(const StepInputs& inputs, EventList& events) noexcept {
  events.clear();
  now_ = inputs.tick;
  reporter_.report_overrun(inputs.skipped, report_inputs(), events);
  prediction_.advance_skipped_ticks(inputs.skipped, command_, circuit());
  const Tick ticks = 1 + static_cast<Tick>(inputs.skipped);
  return model::kTickSeconds * static_cast<double>(std::min(ticks, kLongestGap));
}

void Controller::sense(const StepInputs& inputs, double dt_s) noexcept {
  if (inputs.board_fresh) {
    board_ = inputs.board;
    apply_board_limits();
  }
  pair_.step(inputs.board_fresh, inputs.board);
  visibility_.step(pair_, board_.bridges_awake, command_.enable(), prediction_.a(), dt_s);
  heading_.step(inputs.orientation, now_);
}

Reason Controller::check(const StepInputs& inputs, double dt_s) noexcept {
  const Reason found =
      watchdog_.step({inputs.board_present, inputs.board_fresh, board_, pair_, command_,
                      limits_.trip_c, 1 + static_cast<Tick>(inputs.skipped), states_.armed(),
                      states_.arming(), now_, inputs.thermometer});
  const Reason estimated = update_estimate(dt_s);
  if (found == Reason::kMeasurementsDisagree)
    disagreement_ = watchdog_.disagreement();
  else if (estimated == Reason::kMeasurementsDisagree)
    disagreement_ = estimate_.disagreement();
  return found != Reason::kNone ? found : estimated;
}

void Controller::arbitrate(Reason found, const StepInputs& inputs, EventList& events) noexcept {
  update_state(found, inputs.board_present, inputs.board_fresh);
  apply_requests(inputs, events);

  const State before = states_.state();
  states_.step(board_, inputs.board_fresh, arming_blocker(), now_);
  if (states_.state() == before) return;
  if (states_.armed()) watchdog_.begin_armed();
  // Reason of a board that did not clear its latch.
  if (states_.state() == State::kTripped) record_trip(states_.reason());
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

void Controller::apply_requests(const StepInputs& inputs, EventList& events) noexcept {
  const bool emergency = inputs.emergency_generation != emergency_generation_;
  emergency_generation_ = inputs.emergency_generation;
  for (int i = 0; i < inputs.stop_count; ++i)
    mixer_.stop(inputs.stops[static_cast<std::size_t>(i)], now_, events);
  for (int i = 0; i < inputs.command_count; ++i)
    apply_command(inputs.commands[static_cast<std::size_t>(i)], events);
  // After the commands, so that no arming of the same tick survives it.
  if (emergency) states_.emergency_stop(now_);
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
  } else if (std::holds_alternative<ResetBall>(command.what)) {
    on_ball_replaced();
  } else if (std::holds_alternative<EnterBootLoader>(command.what)) {
    states_.enter_boot_loader(now_);
  }
}

Reason Controller::arming_blocker() const noexcept {
  if (states_.boot_loader_pending()) return Reason::kBootLoader;
  const Reason implausible = watchdog_.arming_blocker();
  if (implausible != Reason::kNone) return implausible;
  // A board's heat latch may be older than this daemon.
  constexpr std::uint16_t kByHeat = board::kOverHeat | board::kHeatBudget;
  const auto board_heat = static_cast<std::uint16_t>(board_.faults & kByHeat);
  const Reason why = board_heat != 0 ? reason_of_faults(board_heat) : states_.reason();
  // The lost state may have contained an over-temperature trip.
  const bool by_heat = why == Reason::kOverheated || why == Reason::kBoardOverHeat ||
                       why == Reason::kBoardHeatBudget || why == Reason::kStateLost;
  const model::ThermalEstimate& thermal = observer_.estimate();
  const double cool_c = model::rearm_below_c(limits_, thermal.ambient_c);
  if (by_heat && !(thermal.hottest_c < cool_c)) return why;
  if (states_.reason() == Reason::kShellHot && watchdog_.thermometer().too_warm_to_arm())
    return Reason::kShellHot;
  const FanCheck& fan = watchdog_.fan();
  if (fan.stopped() || (states_.reason() == Reason::kFanStopped && fan.stalled()))
    return Reason::kFanStopped;
  return states_.rearm_wait(now_) > 0 ? states_.latch() : Reason::kNone;
}

void Controller::account(const MixResult& mix, const model::CoilCurrents& demand) noexcept {
  demand_a_ = field_demand(mix, settings_.coils).a;
  mixer_.account(delivered_share(demand, passed_));
  derating_.step(mix.any ? std::min(norm(demand.a), limits_.current_a) : 0.0,
                 limiter_.allowed().value, now_);
}

void Controller::reject_non_finite(double dt_s, EventList& events) noexcept {
  const bool rejected = limiter_.rejected();
  if (rejected) {
    demand_a_ = {};
    reporter_.report_rejection(report_inputs(), events);
  }
  if (non_finite_.step(rejected, dt_s, kNonFiniteHoldS) && states_.armed()) {
    record_trip(Reason::kInternal);
    states_.trip(Reason::kInternal, now_);
  }
}

std::uint8_t Controller::fan_duty(double dt_s) noexcept {
  const std::uint8_t duty = fan_.step(hottest_c(), norm(present_a()), dt_s);
  return states_.state() == State::kTripped ? model::Fan::kFullDuty : duty;
}

WindingCircuit Controller::circuit() const noexcept {
  return {observer_.estimate().resistance_ohm, settings_.coils.inductance_h, board_.supply_v};
}

void Controller::record_trip(Reason reason) noexcept {
  last_trip_ = {reason, now_, hottest_c(), norm(pair_.after_a()), {}};
  if (reason == Reason::kMeasurementsDisagree) last_trip_.disagreement = disagreement_;
  if (reason == Reason::kOverheated)
    last_trip_.disagreement =
        estimate_.contradicting_heat(observer_, watchdog_.supply(), limits_.trip_c);
}

void Controller::end_all(EndReason reason, EventList& events) noexcept {
  events.clear();
  mixer_.end_all(reason, now_, events);
}

}  // namespace hedgehog::control
