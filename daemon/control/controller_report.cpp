// SPDX-License-Identifier: MIT
// What the controller tells: events of a tick, and the snapshot.
#include <algorithm>

#include "daemon/control/controller.h"

namespace hedgehog::control {

void Controller::end_all(EndReason reason, EventList& events) noexcept {
  events.clear();
  mixer_.end_all(reason, now_, events);
}

void Controller::report(EventType type, EventList& events, std::uint64_t count) const noexcept {
  Event event;
  event.type = type;
  event.state = states_.state();
  event.reason = states_.reason();
  event.tick = now_;
  event.trip = type == EventType::kStateChanged && last_trip_.tick == now_;
  event.limit_a = limiter_.allowed().value;
  event.current_a = norm(pair_.after_a());
  event.temperature_c = thermal().hottest_c;
  event.count = count;
  if (event.trip) event.disagreement = last_trip_.disagreement;
  events.push(event);
}

void Controller::report_overrun(std::uint32_t skipped, EventList& events) noexcept {
  constexpr model::Tick kEvery = model::kTicksPerSecond;
  unreported_overruns_ += started_ ? skipped : 0;
  if (unreported_overruns_ == 0 || now_ - last_overrun_report_ < kEvery) return;
  report(EventType::kOverrun, events, unreported_overruns_);
  last_overrun_report_ = now_;
  unreported_overruns_ = 0;
}

void Controller::report_changes(EventList& events) noexcept {
  const bool attached = watchdog_.board().alive();
  if (attached != reported_.attached)
    report(attached ? EventType::kDeviceAttached : EventType::kDeviceDetached, events);
  if (states_.state() != reported_.state || states_.reason() != reported_.reason)
    report(EventType::kStateChanged, events);
  if (heading_.present() && heading_.fresh() != reported_.oriented) {
    report(heading_.fresh() ? EventType::kOrientationRestored : EventType::kOrientationLost,
           events);
  }
  if (derating_.active() != reported_.derating)
    report(derating_.active() ? EventType::kDeratingStarted : EventType::kDeratingEnded, events);
  reported_ = {states_.state(), states_.reason(), attached, heading_.fresh(), derating_.active()};
}

void Controller::fill(StatusSnapshot& s) const noexcept {
  s.tick = now_;
  s.state = states_.state();
  s.reason = states_.reason();
  s.since = states_.since();
  s.arming_blocker = arming_blocker();
  s.latch = states_.latch();
  s.rearm_wait = states_.rearm_wait(now_);
  s.rearms = states_.rearms();

  s.board_present = watchdog_.board().alive();
  s.board = board_;
  s.sensor_age_s = watchdog_.sensor().age_s();
  s.sensor_valid = s.board_present && watchdog_.sensor().usable();
  s.fan_cooling = watchdog_.fan().cooling();
  s.fan_works = watchdog_.fan().works();
  s.thermometer_known = watchdog_.thermometer().known();
  s.thermometer_c = watchdog_.thermometer().celsius();

  s.thermal = thermal();
  for (int coil = 0; coil < model::kCoils; ++coil) {
    const model::WindingThermometer& winding = observer_.winding(coil);
    const bool known = observing_ && winding.referenced();
    s.r25_ohm[static_cast<std::size_t>(coil)] = known ? winding.r25_ohm() : 0.0;
  }
  s.skin = skin();
  s.limit_a = limiter_.allowed().value;
  s.derating = derating_.active();

  s.demand_a = demand_a_;
  s.limited_a = passed_.a();
  s.gain = settings_.gain;

  s.orientation_present = heading_.present();
  s.orientation_fresh = heading_.fresh();
  s.orientation = heading_.device_to_world();
  s.orientation_rate_deg_s = heading_.rate_deg_s();
  s.orientation_age = heading_.age();
  s.yaw_offset_deg = heading_.yaw_offset_deg();

  mixer_.fill(s.effects);
  s.applied_seq = applied_seq_;
  s.last_trip = last_trip_;
}

}  // namespace hedgehog::control
