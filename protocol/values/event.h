// SPDX-License-Identifier: MIT
// Events for subscribed clients (protocol/README.md). One flat object on the wire; the comments
// list the types that have each field.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace hedgehog::protocol {

class Fields;

/// Sorted. Clients ignore unknown types.
inline constexpr std::array<std::string_view, 13> kEventTypes{"derating_ended",
                                                              "derating_started",
                                                              "device_attached",
                                                              "device_detached",
                                                              "effect_ended",
                                                              "effect_started",
                                                              "measurement_accepted",
                                                              "measurement_rejected",
                                                              "orientation_lost",
                                                              "orientation_restored",
                                                              "overrun",
                                                              "shutting_down",
                                                              "state_changed"};

/// Event types that recur while a condition persists, such as an overloaded host. Events of one
/// type and disagreement at most `kSeriesMaxGapMs` apart form one series of at most `kSeriesMaxMs`,
/// stored as its first event, their number, and the time of the last.
inline constexpr std::array<std::string_view, 5> kRecurringEventTypes{
    "measurement_accepted", "measurement_rejected", "orientation_lost", "orientation_restored",
    "overrun"};
inline constexpr std::int64_t kSeriesMaxGapMs = 60'000;
inline constexpr std::int64_t kSeriesMaxMs = 3'600'000;

/// True if events of this type form series.
constexpr bool is_recurring(std::string_view type) noexcept {
  return std::find(kRecurringEventTypes.begin(), kRecurringEventTypes.end(), type) !=
         kRecurringEventTypes.end();
}

/// effect_ended: delivered fraction of the requested strength.
struct EventDelivery {
  double min = 1.0;
  double mean = 1.0;
  void describe(Fields& f);
  friend bool operator==(const EventDelivery&, const EventDelivery&) = default;
};

/// Measurements that contradict each other.
struct Disagreement {
  /// The winding, 0..2.
  std::int64_t coil = 0;
  /// Two, or more if not distinguishable, of `resistance current heat_balance thermistor
  /// supply_current supply_voltage`.
  std::vector<std::string> between{};
  void describe(Fields& f);
  friend bool operator==(const Disagreement&, const Disagreement&) = default;
};

/// Fields that a type does not have are nullopt and omitted.
struct Event {
  std::string type{};
  std::int64_t time_ns = 0;

  // effect_started, effect_ended
  std::optional<std::uint32_t> effect{};
  std::optional<std::string> slot{};  // written as null when the effect has none
  // effect_started
  std::optional<std::uint64_t> seq{};

  // effect_ended, state_changed (null there when armed), shutting_down
  std::optional<std::string> reason{};
  // effect_ended; onset and offset are null when it never played
  std::optional<std::int64_t> onset_ns{};
  std::optional<std::int64_t> offset_ns{};
  std::optional<EventDelivery> delivered{};
  std::optional<std::int64_t> masked_ms{};
  std::optional<std::int64_t> mixed_ms{};

  // state_changed
  std::optional<std::string> state{};
  std::optional<std::string> remedy{};

  // derating_started, derating_ended
  std::optional<double> limit_a{};
  // also state_changed by a trip: hottest temperature, if known, and current (always)
  std::optional<double> temperature_c{};
  std::optional<double> current_a{};
  // measurement_rejected, measurement_accepted; state_changed by a trip with reason
  // measurements_disagree or overheated
  std::optional<Disagreement> disagreement{};

  // device_attached, device_detached: "board" or "imu"
  std::optional<std::string> device{};
  // overrun: ticks skipped
  std::optional<std::uint64_t> skipped{};

  void describe(Fields& f);
  friend bool operator==(const Event&, const Event&) = default;
};

constexpr bool is_derating(std::string_view type) noexcept {
  return type == "derating_started" || type == "derating_ended";
}

/// True if the ball has tripped or was disconnected while armed; not for a trip persisted over a
/// restart.
inline bool is_trip(const Event& event) noexcept {
  return event.state.has_value() && event.current_a.has_value();
}

}  // namespace hedgehog::protocol
