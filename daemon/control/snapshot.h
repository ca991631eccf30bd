// SPDX-License-Identifier: MIT
// Complete state after a tick, for io: `device.status`, telemetry, admission. Trivially copyable;
// control -> io by triple buffer.
#pragma once

#include <array>
#include <cstdint>
#include <type_traits>

#include "base/histogram.h"
#include "daemon/control/effects/command.h"
#include "daemon/control/state/disagreement.h"
#include "daemon/control/state/rearm_backoff.h"
#include "daemon/control/state/state.h"
#include "daemon/device/board_io.h"
#include "model/estimate/skin_estimate.h"
#include "model/estimate/thermal_observer.h"
#include "model/quaternion.h"
#include "model/tick.h"

namespace hedgehog::control {

struct EffectStatus {
  EffectId effect = 0;        // 0: the place is free
  bool playing = false;       // false while delayed or masked by a higher priority
  model::Tick remaining = 0;  // until it ends by itself
  double current_a = 0.0;     // its own share of the present current; 0 while masked
};

struct LoopStatistics {
  double rate_hz = 0.0;
  std::uint64_t ticks = 0;
  std::uint64_t skipped = 0;
  double lateness_p50_us = 0.0;
  double lateness_p99_us = 0.0;
  double lateness_max_us = 0.0;
  base::Histogram lateness;
  base::Histogram work;  // execution time of a tick
};

/// Sums over every tick since the start: sampling would miss bursts of 150 ms.
struct Totals {
  model::Vec3 on_s;       // integral of the measured |duty| of each bridge
  double heat_a2s = 0.0;  // integral of the measured |I|^2, all windings together
  /// Greatest measured |I|^2 of the last 17 to 32 ticks: io, every 10 ms in real time, misses none.
  double peak_a2 = 0.0;
  double derated_s = 0.0;           // time with a derated effect
  base::Histogram request_to_coil;  // from reading a request to passing its set-point to the link
};

struct Trip {
  Reason reason = Reason::kNone;
  model::Tick tick = -1;
  double temperature_c = 0.0;
  double current_a = 0.0;
  /// Of kMeasurementsDisagree; of kOverheated if others contradict the reading at the trip.
  Disagreement disagreement;
};

struct SkinStatus {
  model::SkinEstimate estimate;
  /// Excess over `estimate.heated_c()` for the limit: the margin, or by a probe under the skin.
  double above_k = 0.0;
  double bound_c = 25.0;
};

struct StatusSnapshot {
  model::Tick tick = 0;
  State state = State::kAbsent;
  Reason reason = Reason::kNoBoard;
  model::Tick since = 0;
  /// Reason of a trip that would recur at once if armed now (kNone: arming is possible).
  Reason arming_blocker = Reason::kNone;
  Reason latch = Reason::kNone;  // must persist over a restart; kNone: none
  model::Tick rearm_wait = 0;    // until that latch may be cleared
  RearmCounts rearms{};          // how often each reason was cleared

  bool board_present = false;
  device::BoardTelemetry board;
  double sensor_age_s = 0.0;  // of the thermistor reading, since its conversion
  bool sensor_valid = false;  // usable, by the watchdog

  bool fan_cooling = false;  // credited with cooling the core, by its tachometer, while driven
  bool fan_works = true;

  bool thermometer_known = false;  // the second one is configured and delivers readings
  double thermometer_c = 0.0;

  model::ThermalEstimate thermal;
  /// R25 of each winding by comparison with a thermistor since the start, ohm, including this
  /// board's gain errors; 0: not yet known.
  std::array<double, model::kCoils> r25_ohm{};
  SkinStatus skin;
  double limit_a = 0.0;   // allowed now
  bool derating = false;  // an effect is being derated now

  model::Vec3 demand_a;   // after mixing, device frame
  model::Vec3 limited_a;  // winding currents passed by the limiter
  double gain = 1.0;      // the owner's comfort setting

  bool orientation_present = false;
  bool orientation_fresh = false;  // not older than 100 ms
  model::Quaternion orientation;   // device -> world, recentred
  model::Vec3 orientation_rate_deg_s;
  model::Tick orientation_age = 0;
  double yaw_offset_deg = 0.0;

  std::array<EffectStatus, kEffectPlaces> effects{};
  std::uint64_t applied_seq = 0;
  LoopStatistics loop;
  Totals totals;
  device::LinkCounters link;
  Trip last_trip;
};

static_assert(std::is_trivially_copyable_v<StatusSnapshot>);

}  // namespace hedgehog::control
