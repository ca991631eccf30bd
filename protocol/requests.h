// SPDX-License-Identifier: MIT
// Every request as a value. Its fields are the method's parameters, under their wire names.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "model/quaternion.h"
#include "protocol/effect_params.h"
#include "protocol/method.h"
#include "protocol/pattern.h"
#include "protocol/sim_error.h"
#include "protocol/status_keys.h"

namespace hedgehog::protocol {

/// Numbers an effect for as long as the daemon runs; at least 1.
using EffectNumber = std::uint32_t;

enum class Scope : std::uint8_t { kMine, kAll };

struct Hello {
  std::string client{};    // at most 128 characters, shown to the operator; empty: not said
  std::string protocol{};  // "1.0"; empty: not said
  std::optional<std::string> token{};
  friend bool operator==(const Hello&, const Hello&) = default;
};

struct Ping {
  friend bool operator==(const Ping&, const Ping&) = default;
};

/// effect.pulse, effect.circle, effect.vibrate, effect.hold, effect.play.
struct EffectStart {
  Method method = Method::kEffectPulse;
  EffectParams params{};
  friend bool operator==(const EffectStart&, const EffectStart&) = default;
};

/// Exactly one of `effect` and `params.slot` says which.
struct EffectUpdate {
  std::optional<EffectNumber> effect{};
  EffectParams params{};
  friend bool operator==(const EffectUpdate&, const EffectUpdate&) = default;
};

/// Exactly one of the two.
struct EffectStop {
  std::optional<EffectNumber> effect{};
  std::optional<std::string> slot{};
  friend bool operator==(const EffectStop&, const EffectStop&) = default;
};

struct EffectStopAll {
  Scope scope = Scope::kMine;
  friend bool operator==(const EffectStopAll&, const EffectStopAll&) = default;
};

/// On the wire: `method` and `params`.
struct EffectPreview {
  std::optional<EffectStart> start{};  // always there once decoded
  friend bool operator==(const EffectPreview&, const EffectPreview&) = default;
};

struct DeviceDescribe {
  friend bool operator==(const DeviceDescribe&, const DeviceDescribe&) = default;
};
struct DeviceList {
  friend bool operator==(const DeviceList&, const DeviceList&) = default;
};
struct DeviceStatus {
  friend bool operator==(const DeviceStatus&, const DeviceStatus&) = default;
};
struct DeviceEmergencyStop {
  friend bool operator==(const DeviceEmergencyStop&, const DeviceEmergencyStop&) = default;
};
struct DeviceArm {
  friend bool operator==(const DeviceArm&, const DeviceArm&) = default;
};

/// Renewed by claiming again.
struct DeviceClaim {
  std::int64_t lease_ms = kMaxLeaseMs;  // 100..10 000
  friend bool operator==(const DeviceClaim&, const DeviceClaim&) = default;
};
struct DeviceRelease {
  friend bool operator==(const DeviceRelease&, const DeviceRelease&) = default;
};

struct OutputSetGain {
  double gain = 1.0;  // 0..1
  friend bool operator==(const OutputSetGain&, const OutputSetGain&) = default;
};

/// Exactly one of `current_a`, `start` and `effect`. Without a `direction` a current is forecast
/// for the worst coil.
struct ThermalForecast {
  std::optional<double> current_a{};  // not negative
  std::optional<Direction> direction{};
  std::optional<EffectStart> start{};  // on the wire: `method` and `params`
  std::optional<EffectNumber> effect{};
  friend bool operator==(const ThermalForecast&, const ThermalForecast&) = default;
};

struct OrientationSet {
  model::Quaternion quaternion{};  // device -> world; said within 1 % of unit length, normalised
  friend bool operator==(const OrientationSet&, const OrientationSet&) = default;
};

/// The front points there now.
struct OrientationRecenter {
  double azimuth_deg = 0.0;  // -360..360
  friend bool operator==(const OrientationRecenter&, const OrientationRecenter&) = default;
};

struct TelemetrySubscribe {
  double rate_hz = 10.0;                  // 0.1..200
  StatusKeys fields = kTelemetryDefault;  // time_ns always goes along
  friend bool operator==(const TelemetrySubscribe&, const TelemetrySubscribe&) = default;
};
struct TelemetryUnsubscribe {
  friend bool operator==(const TelemetryUnsubscribe&, const TelemetryUnsubscribe&) = default;
};

struct EventsSubscribe {
  std::vector<std::string> types{};  // names of kEventTypes (protocol/event.h); empty: all
  Scope scope = Scope::kMine;        // whose effects; the ball's own events always come
  friend bool operator==(const EventsSubscribe&, const EventsSubscribe&) = default;
};
struct EventsUnsubscribe {
  friend bool operator==(const EventsUnsubscribe&, const EventsUnsubscribe&) = default;
};

struct EventsHistory {
  static constexpr std::int64_t kMaxEvents = 1000;
  std::optional<std::string> since{};  // RFC 3339
  std::vector<std::string> types{};    // empty: all
  bool trips = false;                  // nothing but trips
  std::int64_t limit = 100;            // 1..kMaxEvents
  friend bool operator==(const EventsHistory&, const EventsHistory&) = default;
};

struct PatternList {
  friend bool operator==(const PatternList&, const PatternList&) = default;
};
struct PatternGet {
  std::string name{};
  friend bool operator==(const PatternGet&, const PatternGet&) = default;
};
/// Replaces the one of that name.
struct PatternPut {
  Pattern pattern{};  // its fields are the parameters
  friend bool operator==(const PatternPut&, const PatternPut&) = default;
};
struct PatternRemove {
  std::string name{};
  friend bool operator==(const PatternRemove&, const PatternRemove&) = default;
};

struct ConnectionList {
  friend bool operator==(const ConnectionList&, const ConnectionList&) = default;
};

/// Replaces all faults of the simulated board: `faults` empty mends it.
struct SimFault {
  std::vector<std::string> faults{};  // wire names of device::SimFault; the server knows them
  std::int64_t coil = 0;              // 0..2: which winding the faults of one winding touch
  friend bool operator==(const SimFault&, const SimFault&) = default;
};

/// What is left out stays as it is.
struct SimSet {
  std::optional<model::Quaternion> orientation{};
  std::optional<double> ambient_c{};  // -20..60
  std::optional<SimFault> fault{};
  std::optional<std::vector<SimError>> errors{};  // replaces all
  friend bool operator==(const SimSet&, const SimSet&) = default;
};

struct SimTruth {
  friend bool operator==(const SimTruth&, const SimTruth&) = default;
};

using Request =
    std::variant<Hello, Ping, EffectStart, EffectUpdate, EffectStop, EffectStopAll, DeviceDescribe,
                 DeviceStatus, DeviceEmergencyStop, DeviceArm, DeviceClaim, DeviceRelease,
                 OutputSetGain, ThermalForecast, OrientationSet, OrientationRecenter,
                 TelemetrySubscribe, TelemetryUnsubscribe, EventsSubscribe, EventsUnsubscribe,
                 EffectPreview, EventsHistory, PatternList, PatternGet, PatternPut, PatternRemove,
                 ConnectionList, DeviceList, SimSet, SimTruth>;

/// The method that `request` calls.
Method method_of(const Request& request) noexcept;

}  // namespace hedgehog::protocol
