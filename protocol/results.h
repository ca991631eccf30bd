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
#include "protocol/role.h"
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

/// effect.pulse, circle, vibrate, hold, update.
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

/// sim.set: how the simulated world is now.
struct SimResult {
  double ambient_c = 25.0;
  std::vector<std::string> faults{};
  std::int64_t coil = 0;
  friend bool operator==(const SimResult&, const SimResult&) = default;
};

/// device.release, orientation.set, telemetry.unsubscribe, events.unsubscribe: {}.
struct Done {
  friend bool operator==(const Done&, const Done&) = default;
};

using ResultValue =
    std::variant<Done, HelloResult, PingResult, Admission, StopResult, StateResult, ClaimResult,
                 GainResult, ForecastResult, RecenterResult, TelemetryResult, EventsResult,
                 ConnectionsResult, SimResult, Status, Description>;

}  // namespace hedgehog::protocol
