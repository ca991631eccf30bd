// SPDX-License-Identifier: MIT
// telemetry.*
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "protocol/method_info.h"
#include "protocol/methods/done.h"
#include "protocol/values/status_keys.h"
#include "protocol/wire/fields.h"

namespace hedgehog::protocol {

struct TelemetryResult {
  static constexpr std::string_view kSchema = "TelemetrySubscription";
  double rate_hz = 0.0;
  StatusKeys fields{};

  void describe(Fields& f);
  friend bool operator==(const TelemetryResult&, const TelemetryResult&) = default;
};

struct TelemetrySubscribe {
  static constexpr MethodInfo kMethod{"telemetry.subscribe", Role::kObserve,
                                      "Subscribes to periodic notifications of the status."};
  using Result = TelemetryResult;

  double rate_hz = 10.0;                  // 0.1..200
  StatusKeys fields = kTelemetryDefault;  // time_ns is always included

  void describe(Fields& f);
  friend bool operator==(const TelemetrySubscribe&, const TelemetrySubscribe&) = default;
};

struct TelemetryUnsubscribe {
  static constexpr MethodInfo kMethod{"telemetry.unsubscribe", Role::kObserve,
                                      "Ends the subscription to telemetry."};
  using Result = Done;
  friend bool operator==(const TelemetryUnsubscribe&, const TelemetryUnsubscribe&) = default;
};

/// One step of telemetry.history.
struct TelemetrySample {
  double age_s = 0.0;  // age of its end relative to `time_ns`
  // Values at its end; omitted where not known
  std::optional<std::array<double, 3>> coils_c{};  // estimated windings
  std::optional<double> upper_c{};                 // upper bound of the hottest winding
  std::optional<double> sensor_c{};                // the thermistor
  double current_a = 0.0;                          // rms of the norm over the step
  double peak_a = 0.0;                             // maximum norm
  double limit_a = 0.0;                            // minimum allowed
  std::array<double, 3> duty{};                    // mean magnitudes, 0..1
  std::optional<double> headroom_s{};              // minimum; null: unlimited, or not known

  void describe(Fields& f);
  friend bool operator==(const TelemetrySample&, const TelemetrySample&) = default;
};

struct TelemetryHistoryResult {
  static constexpr std::string_view kSchema = "TelemetryHistory";
  static constexpr std::int64_t kMaxSamples = 200;
  std::int64_t time_ns = 0;                // present device time
  double step_s = 0.0;                     // duration of one sample
  std::vector<TelemetrySample> samples{};  // oldest first; missing ones were not measured

  void describe(Fields& f);
  friend bool operator==(const TelemetryHistoryResult&, const TelemetryHistoryResult&) = default;
};

struct TelemetryHistory {
  static constexpr MethodInfo kMethod{"telemetry.history", Role::kObserve,
                                      "Temperatures and currents of the last minutes."};
  using Result = TelemetryHistoryResult;
  static constexpr double kMaxSeconds = 600.0;

  double seconds = 120.0;  // 1..kMaxSeconds

  void describe(Fields& f);
  friend bool operator==(const TelemetryHistory&, const TelemetryHistory&) = default;
};

using TelemetryMethods = TypeList<TelemetrySubscribe, TelemetryUnsubscribe, TelemetryHistory>;

}  // namespace hedgehog::protocol
