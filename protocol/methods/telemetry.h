// SPDX-License-Identifier: MIT
// telemetry.*
#pragma once

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
                                      "Asks for the status again and again."};
  using Result = TelemetryResult;

  double rate_hz = 10.0;                  // 0.1..200
  StatusKeys fields = kTelemetryDefault;  // time_ns always goes along

  void describe(Fields& f);
  friend bool operator==(const TelemetrySubscribe&, const TelemetrySubscribe&) = default;
};

struct TelemetryUnsubscribe {
  static constexpr MethodInfo kMethod{"telemetry.unsubscribe", Role::kObserve,
                                      "Ends the subscription to telemetry."};
  using Result = Done;
  friend bool operator==(const TelemetryUnsubscribe&, const TelemetryUnsubscribe&) = default;
};

using TelemetryMethods = TypeList<TelemetrySubscribe, TelemetryUnsubscribe>;

}  // namespace hedgehog::protocol
