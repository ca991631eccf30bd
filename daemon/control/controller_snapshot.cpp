// SPDX-License-Identifier: MIT
// State of the controller for events and for the snapshot.
#include "daemon/control/controller.h"

namespace hedgehog::control {

ReportInputs Controller::report_inputs() const noexcept {
  return {now_,
          states_.state(),
          states_.reason(),
          watchdog_.board().alive(),
          heading_.present(),
          heading_.fresh(),
          derating_.active(),
          rejected_.rejected(),
          limiter_.allowed().value,
          norm(pair_.after_a()),
          hottest_c(),
          last_trip_};
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
