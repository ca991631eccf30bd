// SPDX-License-Identifier: MIT
// The status object: result of `device.status`, content of telemetry (protocol/README.md). nullopt
// is written as null: not known, or unlimited, depending on the field.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "model/geometry/pin_motion.h"
#include "model/quaternion.h"
#include "model/vec3.h"
#include "protocol/values/event.h"
#include "protocol/values/status_keys.h"

namespace hedgehog::protocol {

class Fields;

struct TemperatureStatus {
  std::optional<double> sensor{};  // null: stale or out of range; see `age_ms`
  std::optional<double> model{};   // estimated hottest winding
  std::array<double, 3> coils{};
  std::optional<std::int64_t> age_ms{};  // null: no reading so far
  std::optional<double> thermometer{};   // second thermometer; omitted if absent or stale
  std::optional<double> upper{};         // upper bound of the hottest, used by the limiter
  std::optional<double> core{};          // estimated core between the windings
  /// Thermistors of windings x, y, z; omitted unless the board has one on each and all are valid.
  std::optional<std::array<double, 3>> sensors{};
  std::optional<double> skin{};  // upper bound of the shell, now and later; also limits
  void describe(Fields& f);
  friend bool operator==(const TemperatureStatus&, const TemperatureStatus&) = default;
};

struct FanStatus {
  std::optional<double> speed_rpm{};
  double duty = 0.0;  // 0..1
  /// True if its speed shows that it cools; used by the estimate. Absent: older daemon.
  std::optional<bool> cooling{};
  void describe(Fields& f);
  friend bool operator==(const FanStatus&, const FanStatus&) = default;
};

struct OrientationStatus {
  model::Quaternion quaternion{};  // device -> world, recentred
  model::Vec3 up{0, 0, 1};         // opposite to gravity, device frame
  model::Vec3 rate_deg_s{};
  std::int64_t age_ms = 0;
  void describe(Fields& f);
  friend bool operator==(const OrientationStatus&, const OrientationStatus&) = default;
};

struct EffectStatus {
  std::uint32_t effect = 0;
  std::optional<std::string> slot{};
  std::string method{};
  std::int64_t connection = 0;
  std::optional<std::string> client{};
  std::int64_t priority = 5;
  bool playing = false;  // false: delayed, or masked by a higher priority
  std::int64_t remaining_ms = 0;
  double current_a = 0.0;
  void describe(Fields& f);
  friend bool operator==(const EffectStatus&, const EffectStatus&) = default;
};

struct LatenessStatus {
  double p50 = 0.0;
  double p99 = 0.0;
  double max = 0.0;
  void describe(Fields& f);
  friend bool operator==(const LatenessStatus&, const LatenessStatus&) = default;
};

struct LoopStatus {
  double rate_hz = 0.0;
  std::uint64_t ticks = 0;
  std::uint64_t skipped = 0;
  LatenessStatus lateness_us{};
  void describe(Fields& f);
  friend bool operator==(const LoopStatus&, const LoopStatus&) = default;
};

struct LinkStatus {
  std::uint64_t frames_out = 0;
  std::uint64_t lost = 0;
  std::uint64_t errors = 0;
  void describe(Fields& f);
  friend bool operator==(const LinkStatus&, const LinkStatus&) = default;
};

struct TripStatus {
  std::string reason{};
  std::int64_t time_ns = 0;
  std::optional<double> temperature_c{};
  double current_a = 0.0;
  std::optional<Disagreement> disagreement{};  // of measurements_disagree, overheated
  void describe(Fields& f);
  friend bool operator==(const TripStatus&, const TripStatus&) = default;
};

struct Status {
  static constexpr std::string_view kSchema = "Status";
  std::string device{};
  bool simulated = false;
  std::int64_t time_ns = 0;
  std::string state{};  // absent, disarmed, armed, tripped
  std::optional<std::string> reason{};
  double since_s = 0.0;
  std::optional<std::string> remedy{};

  TemperatureStatus temperature_c{};
  double limit_a = 0.0;                // allowed now
  std::optional<double> headroom_s{};  // of the present current; null: unlimited
  std::optional<double> burst_s{};     // of the full limits.current_a
  bool derating = false;

  model::Vec3 current_a{};            // measured, per coil
  model::Vec3 duty{};                 // per coil, -1..1
  std::optional<double> supply_v{};   // of the bridges, measured; null: no board
  model::Vec3 field{};                // unit vector in the device frame; zero without current
  double force_n = 0.0;               // at the nearest pin
  std::optional<std::int64_t> pin{};  // the nearest; null without current

  FanStatus fan{};
  std::optional<OrientationStatus> orientation{};  // null: no sensor
  std::vector<EffectStatus> effects{};
  LoopStatus loop{};
  LinkStatus link{};
  std::uint64_t applied_seq = 0;
  std::optional<TripStatus> last_trip{};

  model::PinMotion pins{};  // from the measured currents; only on request
  void describe(Fields& f);
  friend bool operator==(const Status&, const Status&) = default;
};

/// One `telemetry` notification: the subscribed keys, each complete.
struct Telemetry {
  StatusKeys keys = kTelemetryDefault;
  Status status{};
  void describe(Fields& f);
  friend bool operator==(const Telemetry&, const Telemetry&) = default;
};

void describe(Fields& f, model::PinMotion& v);

}  // namespace hedgehog::protocol
