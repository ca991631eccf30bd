// SPDX-License-Identifier: MIT
// effect.*
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "protocol/method_info.h"
#include "protocol/values/effect_params.h"
#include "protocol/values/event.h"
#include "protocol/wire/fields.h"

namespace hedgehog::protocol {

/// Number of an effect, unique while the daemon runs; at least 1.
using EffectNumber = std::uint32_t;
inline constexpr Spec kEffectNumber{.min = 1};

enum class Scope : std::uint8_t { kMine, kAll };
Names names_of(Scope) noexcept;

struct Admission {
  static constexpr std::string_view kSchema = "Admission";
  std::uint32_t effect = 0;
  std::optional<std::string> slot{};  // omitted when the effect has none
  bool accepted = true;
  std::optional<std::string> limited_by{};  // thermal, mix, priority, configuration
  double current_a = 0.0;
  double force_n = 0.0;  // at `pin`, the nearest
  std::int64_t pin = 0;
  std::optional<double> headroom_s{};  // null: unlimited
  std::uint64_t seq = 0;
  std::optional<double> period_ms{};  // circles: one turn; omitted for others

  void describe(Fields& f);
  friend bool operator==(const Admission&, const Admission&) = default;
};

/// One method per kind of effect, in the order of the enumerators.
struct EffectStart {
  static constexpr ErrorSet kErrors{ErrorCode::kNotArmed, ErrorCode::kDeviceAbsent,
                                    ErrorCode::kClaimed, ErrorCode::kRefusedThermal};
  static constexpr std::array<MethodInfo, 5> kMethods{{
      {"effect.pulse", Role::kPlay, "One push towards a direction.", kErrors},
      {"effect.circle", Role::kPlay, "The field rotates about an axis, from pin to pin.", kErrors},
      {"effect.vibrate", Role::kPlay, "A push with a waveform.", kErrors},
      {"effect.hold", Role::kPlay, "A push that lasts as long as it is renewed.", kErrors},
      {"effect.play", Role::kPlay, "Plays key frames, of a named pattern or its own.",
       kErrors | ErrorSet{ErrorCode::kNoSuchPattern}},
  }};
  using Result = Admission;

  model::EffectMethod method = model::EffectMethod::kPulse;
  EffectParams params{};

  void describe(Fields& f) { params.describe(f, method); }
  friend bool operator==(const EffectStart&, const EffectStart&) = default;
};

static_assert(EffectStart::kMethods.size() ==
              static_cast<std::size_t>(model::EffectMethod::kPlay) + 1);

/// "effect.pulse", ...
constexpr std::string_view name(model::EffectMethod method) noexcept {
  return EffectStart::kMethods[static_cast<std::size_t>(method)].name;
}

/// Selected by exactly one of `effect` and `params.slot`.
struct EffectUpdate {
  static constexpr MethodInfo kMethod{
      "effect.update",
      Role::kPlay,
      "Changes a playing effect and renews its lease.",
      {ErrorCode::kNoSuchEffect, ErrorCode::kClaimed, ErrorCode::kNoSuchPattern,
       ErrorCode::kDeviceAbsent, ErrorCode::kRefusedThermal}};
  using Result = Admission;

  std::optional<EffectNumber> effect{};
  EffectParams params{};

  void describe(Fields& f);
  friend bool operator==(const EffectUpdate&, const EffectUpdate&) = default;
};

struct StopResult {
  static constexpr std::string_view kSchema = "Stopped";
  std::int64_t stopped = 0;
  std::uint64_t seq = 0;

  void describe(Fields& f) {
    f.required("stopped", stopped);
    f.required("seq", seq);
  }
  friend bool operator==(const StopResult&, const StopResult&) = default;
};

/// Exactly one of the two members is set.
struct EffectStop {
  static constexpr MethodInfo kMethod{"effect.stop",
                                      Role::kPlay,
                                      "Ends one of the connection's own effects.",
                                      {ErrorCode::kNoSuchEffect}};
  using Result = StopResult;

  std::optional<EffectNumber> effect{};
  std::optional<std::string> slot{};

  void describe(Fields& f);
  friend bool operator==(const EffectStop&, const EffectStop&) = default;
};

struct EffectStopAll {
  static constexpr MethodInfo kMethod{"effect.stop_all", Role::kPlay,
                                      "Ends all effects of the connection, or of all connections."};
  using Result = StopResult;

  Scope scope = Scope::kMine;

  void describe(Fields& f) { f.defaulted("scope", scope); }
  friend bool operator==(const EffectStopAll&, const EffectStopAll&) = default;
};

/// The lists have one item (x, y, z) per `step_ms`, the mean over it.
struct PreviewResult {
  static constexpr std::string_view kSchema = "Preview";
  static constexpr std::int64_t kMaxSteps = 200;
  std::int64_t duration_ms = 0;
  std::int64_t step_ms = 1;
  std::vector<std::array<double, 3>> duty{};       // of each bridge, -1..1
  std::vector<std::array<double, 3>> current_a{};  // through each winding
  double peak_current_a = 0.0;                     // the largest norm in any millisecond
  double temperature_c = 25.0;                     // hottest winding: now, and peak
  double peak_temperature_c = 25.0;
  std::optional<std::string> limited_by{};        // "thermal", "configuration"
  std::optional<std::int64_t> limited_from_ms{};  // of thermal
  EventDelivery delivered{};

  void describe(Fields& f);
  friend bool operator==(const PreviewResult&, const PreviewResult&) = default;
};

/// On the wire: `method` and `params`.
struct EffectPreview {
  static constexpr MethodInfo kMethod{
      "effect.preview",
      Role::kObserve,
      "Computes currents and temperatures of an effect without starting it.",
      {ErrorCode::kNotArmed, ErrorCode::kDeviceAbsent, ErrorCode::kNoSuchPattern}};
  using Result = PreviewResult;

  std::optional<EffectStart> start{};  // always set once decoded

  void describe(Fields& f);
  friend bool operator==(const EffectPreview&, const EffectPreview&) = default;
};

/// A start request as a parameter of another request: `method` and `params`.
void describe_planned(Fields& f, std::optional<EffectStart>& start);

struct LatencyQuantiles {
  double p50 = 0.0;
  double p99 = 0.0;
  double max = 0.0;

  void describe(Fields& f);
  friend bool operator==(const LatencyQuantiles&, const LatencyQuantiles&) = default;
};

/// Latencies of the newest effects, microseconds; null without effects.
struct LatencyResult {
  static constexpr std::string_view kSchema = "Latency";
  std::int64_t effects = 0;  // number of effects measured
  /// From reading the request to queueing its command to the control loop.
  std::optional<LatencyQuantiles> received_to_queued_us{};
  /// To the tick that applied it.
  std::optional<LatencyQuantiles> queued_to_applied_us{};
  /// To writing the first frame with its set-point to the board.
  std::optional<LatencyQuantiles> applied_to_written_us{};
  std::optional<LatencyQuantiles> received_to_written_us{};

  void describe(Fields& f);
  friend bool operator==(const LatencyResult&, const LatencyResult&) = default;
};

struct EffectLatency {
  static constexpr MethodInfo kMethod{"effect.latency", Role::kObserve,
                                      "How long effects took from their request to the board."};
  using Result = LatencyResult;
  friend bool operator==(const EffectLatency&, const EffectLatency&) = default;
};

using EffectMethods =
    TypeList<EffectStart, EffectUpdate, EffectStop, EffectStopAll, EffectPreview, EffectLatency>;

}  // namespace hedgehog::protocol
