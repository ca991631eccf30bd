// SPDX-License-Identifier: MIT
// Every successful answer as a value, under its wire names. nullopt is written as null unless the
// comment says "left out".
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "model/vec3.h"
#include "protocol/description.h"
#include "protocol/event.h"
#include "protocol/pattern.h"
#include "protocol/role.h"
#include "protocol/sim_error.h"
#include "protocol/status.h"

namespace hedgehog::protocol {

struct HelloDevice {
  std::string name{};
  std::string model{};
  bool simulated = false;
  friend bool operator==(const HelloDevice&, const HelloDevice&) = default;
};

struct HelloLimits {
  double current_a = 15.0;
  double continuous_a = 5.0;
  double felt_a = 2.1;
  std::int64_t duration_ms = 10'000;
  std::int64_t lease_ms = 10'000;
  std::int64_t effects = 32;
  double frequency_hz = 250.0;
  double telemetry_hz = 200.0;
  std::int64_t line_bytes = 65'536;
  // How long current_a can flow from a ball as warm as its room, by its instruments; left out: for
  // ever.
  std::optional<double> burst_s{};
  friend bool operator==(const HelloLimits&, const HelloLimits&) = default;
};

struct HelloResult {
  std::string server{"hedgehogd"};
  std::string version{};
  std::string protocol{"1.0"};
  std::int64_t connection = 0;
  Role role = Role::kObserve;
  std::string state{};
  std::optional<std::string> reason{};
  std::optional<std::string> remedy{};
  std::vector<std::string> methods{};  // encoding fills in the table when empty
  HelloDevice device{};
  HelloLimits limits{};
  friend bool operator==(const HelloResult&, const HelloResult&) = default;
};

struct PingResult {
  std::int64_t time_ns = 0;
  friend bool operator==(const PingResult&, const PingResult&) = default;
};

/// effect.pulse, circle, vibrate, hold, play, update.
struct Admission {
  std::uint32_t effect = 0;
  std::optional<std::string> slot{};  // left out when the effect has none
  bool accepted = true;
  std::optional<std::string> limited_by{};  // thermal, mix, priority, configuration
  double current_a = 0.0;
  double force_n = 0.0;  // at `pin`, the nearest
  std::int64_t pin = 0;
  std::optional<double> headroom_s{};  // null: for ever
  std::uint64_t seq = 0;
  std::optional<double> period_ms{};  // circles: one turn; left out elsewhere
  friend bool operator==(const Admission&, const Admission&) = default;
};

/// effect.stop, effect.stop_all.
struct StopResult {
  std::int64_t stopped = 0;
  std::uint64_t seq = 0;
  friend bool operator==(const StopResult&, const StopResult&) = default;
};

/// device.arm, device.emergency_stop: the state that follows.
struct StateResult {
  std::string state{};
  std::optional<std::string> reason{};
  std::optional<std::string> remedy{};
  std::uint64_t seq = 0;
  friend bool operator==(const StateResult&, const StateResult&) = default;
};

struct ClaimResult {
  std::int64_t lease_ms = 0;
  friend bool operator==(const ClaimResult&, const ClaimResult&) = default;
};

struct GainResult {
  double gain = 1.0;
  std::uint64_t seq = 0;
  friend bool operator==(const GainResult&, const GainResult&) = default;
};

/// thermal.forecast; null = never, or: need not.
struct ForecastResult {
  std::optional<double> seconds_to_derating{};
  std::optional<double> seconds_to_limit{};
  double sustainable_a = 0.0;
  std::optional<double> recovery_s{};
  friend bool operator==(const ForecastResult&, const ForecastResult&) = default;
};

struct RecenterResult {
  double yaw_offset_deg = 0.0;
  friend bool operator==(const RecenterResult&, const RecenterResult&) = default;
};

struct TelemetryResult {
  double rate_hz = 0.0;
  StatusKeys fields{};
  friend bool operator==(const TelemetryResult&, const TelemetryResult&) = default;
};

/// events.subscribe: where things stand before the first event.
struct EventsResult {
  std::string state{};
  std::optional<std::string> reason{};
  bool derating = false;
  double limit_a = 0.0;
  friend bool operator==(const EventsResult&, const EventsResult&) = default;
};

struct ConnectionInfo {
  std::int64_t connection = 0;
  std::optional<std::string> client{};
  std::string transport{};               // "tcp", "unix", "websocket"
  std::optional<std::string> address{};  // the peer's; null on a Unix socket
  Role role = Role::kObserve;
  double since_s = 0.0;  // seconds it has been connected
  bool claimed = false;
  std::vector<EffectStatus> effects{};
  friend bool operator==(const ConnectionInfo&, const ConnectionInfo&) = default;
};

struct ConnectionsResult {
  std::vector<ConnectionInfo> connections{};
  friend bool operator==(const ConnectionsResult&, const ConnectionsResult&) = default;
};

/// One USB or HID device that this daemon has to do with, or could have.
struct SeenDevice {
  std::string path{};  // "USB 1-3", as the kernel names the port, or "Bluetooth"
  std::string ids{};   // "1209:0001"
  std::string name{};
  std::optional<std::string> serial{};
  std::optional<std::string> firmware{};
  std::optional<std::string> use{};      // "board", "imu", "thermometer"; null: not used
  std::optional<std::string> why_not{};  // a clause; null when it is used
  friend bool operator==(const SeenDevice&, const SeenDevice&) = default;
};

/// What configuration asks for and is not there.
struct MissingDevice {
  std::string use{};
  std::string why{};
  friend bool operator==(const MissingDevice&, const MissingDevice&) = default;
};

/// device.list.
struct DevicesResult {
  std::vector<SeenDevice> devices{};
  std::vector<MissingDevice> missing{};
  std::int64_t others = 0;  // connected, and nothing to this daemon
  friend bool operator==(const DevicesResult&, const DevicesResult&) = default;
};

/// effect.preview. The lists have an item for every `step_ms`, the mean over it; x, y, z.
struct PreviewResult {
  static constexpr std::int64_t kMaxSteps = 200;
  std::int64_t duration_ms = 0;
  std::int64_t step_ms = 1;
  std::vector<std::array<double, 3>> duty{};       // of each bridge, -1..1
  std::vector<std::array<double, 3>> current_a{};  // through each winding
  double peak_current_a = 0.0;                     // the largest norm in any millisecond
  double temperature_c = 25.0;                     // hottest winding: now, and at most
  double peak_temperature_c = 25.0;
  std::optional<std::string> limited_by{};        // "thermal", "configuration"
  std::optional<std::int64_t> limited_from_ms{};  // of thermal
  EventDelivery delivered{};
  friend bool operator==(const PreviewResult&, const PreviewResult&) = default;
};

/// An event of events.history, with what was added for keeping it.
struct PastEvent {
  std::string at{};  // RFC 3339
  Event event{};
  // Of effects, and of trips: what played, and whose; left out when nobody's
  std::optional<std::string> method{};
  std::optional<std::string> client{};
  std::optional<std::string> recording{};  // of a trip: "trip-0017", as long as there is one
  friend bool operator==(const PastEvent&, const PastEvent&) = default;
};
struct HistoryResult {
  std::vector<PastEvent> events{};  // oldest first
  bool more = false;                // older ones match too
  friend bool operator==(const HistoryResult&, const HistoryResult&) = default;
};

/// One of pattern.list, and pattern.put.
struct PatternSummary {
  std::string name{};
  std::string description{};
  std::int64_t duration_ms = 0;  // at rate 1
  std::int64_t keyframes = 0;    // how many
  bool shipped = false;          // read-only
  friend bool operator==(const PatternSummary&, const PatternSummary&) = default;
};
struct PatternsResult {
  std::vector<PatternSummary> patterns{};  // by name
  friend bool operator==(const PatternsResult&, const PatternsResult&) = default;
};
/// pattern.get: the fields of the pattern, and what pattern.list says besides.
struct PatternResult {
  Pattern pattern{};
  std::int64_t duration_ms = 0;
  bool shipped = false;
  friend bool operator==(const PatternResult&, const PatternResult&) = default;
};

/// sim.set: how the simulated world is now.
struct SimResult {
  double ambient_c = 25.0;
  std::vector<std::string> faults{};
  std::int64_t coil = 0;
  std::vector<SimError> errors{};
  friend bool operator==(const SimResult&, const SimResult&) = default;
};
/// sim.truth: the simulated ball as it really is, whatever is measured of it.
struct SimTruthResult {
  std::vector<double> coils_c{};  // each winding
  double core_c = 0.0;
  double skin_c = 0.0;
  std::vector<double> current_a{};
  double ambient_c = 0.0;
  friend bool operator==(const SimTruthResult&, const SimTruthResult&) = default;
};

/// device.release, orientation.set, telemetry.unsubscribe, events.unsubscribe: {}.
struct Done {
  friend bool operator==(const Done&, const Done&) = default;
};

using ResultValue =
    std::variant<Done, HelloResult, PingResult, Admission, StopResult, StateResult, ClaimResult,
                 GainResult, ForecastResult, RecenterResult, TelemetryResult, EventsResult,
                 ConnectionsResult, PreviewResult, HistoryResult, PatternSummary, PatternsResult,
                 PatternResult, DevicesResult, SimResult, SimTruthResult, Status, Description>;

}  // namespace hedgehog::protocol
