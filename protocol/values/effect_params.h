// SPDX-License-Identifier: MIT
// Parameters of the effect methods (protocol/README.md) as received: omitted ones are nullopt.
// Decoding checks every range that does not depend on the ball; the server checks the rest:
// current_a and force_n against limits.current_a, role `operate` for priority 8 and 9 and for frame
// "coil", the kind of end and the circle's parameters in `effect.update`, pins that do not exist.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "model/effect/effect.h"
#include "model/effect/keyframes.h"
#include "protocol/wire/direction.h"
#include "protocol/wire/error.h"
#include "protocol/wire/names.h"

namespace hedgehog::protocol {

class Fields;

enum class OnClose : std::uint8_t { kStop, kFinish };
enum class IfLimited : std::uint8_t { kReduce, kRefuse };
enum class Sense : std::uint8_t { kCounterClockwise, kClockwise };
enum class Stepping : std::uint8_t { kPin, kSmooth };
Names names_of(OnClose) noexcept;
Names names_of(IfLimited) noexcept;
Names names_of(Sense) noexcept;
Names names_of(Stepping) noexcept;

/// A key frame of a pattern; see model::Keyframe.
struct Keyframe {
  std::int64_t t_ms = 0;                 // 0..60 000, non-decreasing
  std::optional<Direction> direction{};  // default: as the previous one; for the first: front
  double level = 0.0;                    // 0..1
  std::optional<model::Ease> ease{};     // default: linear
  void describe(Fields& f);
  friend bool operator==(const Keyframe&, const Keyframe&) = default;
};

/// Times are milliseconds; fractions are rounded to whole control ticks.
struct EffectParams {
  std::optional<Direction> direction{};
  std::optional<model::Frame> frame{};

  /// At most one of the three. level 0..1 of limits.current_a; the others are >= 0.
  std::optional<double> level{};
  std::optional<double> current_a{};
  std::optional<double> force_n{};
  std::optional<double> gain{};  // 0..1

  /// At most one of the two: device time, or 0..10 000 ms from now.
  std::optional<std::int64_t> start_at_ns{};
  std::optional<std::int64_t> delay_ms{};
  std::optional<std::int64_t> attack_ms{};  // 0..10 000
  std::optional<std::int64_t> fade_ms{};    // 0..10 000; never with lease_ms
  std::optional<double> attack_level{};     // 0..1
  std::optional<double> fade_level{};       // 0..1
  std::optional<model::Waveform> waveform{};
  std::optional<double> frequency_hz{};  // 0.5..250
  std::optional<double> on_fraction{};   // 0.05..0.95

  /// At most one of the two: 1..10 000 ms, or 100..10 000 ms.
  std::optional<std::int64_t> duration_ms{};
  std::optional<std::int64_t> lease_ms{};
  std::optional<OnClose> on_close{};  // kFinish only with duration_ms <= 2000

  std::optional<std::string> slot{};       // 1..32 characters
  std::optional<std::int64_t> priority{};  // 0..9
  std::optional<IfLimited> if_limited{};

  /// effect.circle, and effect.update of one.
  std::optional<Direction> axis{};
  std::optional<double> ring_deg{};      // 0..180
  std::optional<double> speed_pins_s{};  // 0.1..100
  std::optional<Sense> sense{};
  std::optional<Stepping> stepping{};

  /// effect.play (exactly one of the first two), and effect.update of one.
  std::optional<std::string> pattern{};
  std::optional<std::vector<Keyframe>> keyframes{};  // 1..256
  std::optional<Direction> rotate_to{};
  std::optional<double> rate{};  // 0.1..10
  std::optional<bool> loop{};

  /// `method`: of a start; nullopt: an update.
  void describe(Fields& f, std::optional<model::EffectMethod> method);
  friend bool operator==(const EffectParams&, const EffectParams&) = default;
};

inline constexpr std::int64_t kMaxDurationMs = 10'000;
inline constexpr std::int64_t kMinLeaseMs = 100;
inline constexpr std::int64_t kMaxLeaseMs = 10'000;
inline constexpr std::int64_t kMaxFinishMs = 2'000;
inline constexpr std::int64_t kMaxSlotCharacters = 32;
inline constexpr std::int64_t kMaxPatternName = 65;

/// `params` with the defaults of `method`. Not filled in: strength (none = limits.continuous_a),
/// start, slot, and `direction` of pulse and hold (decoding rejects them without one). Without
/// duration_ms and lease_ms, vibrate and circle end after 1000 ms and a loop by its lease of 1000
/// ms; a pattern that does not loop ends with its last key frame (both stay nullopt).
EffectParams with_defaults(model::EffectMethod method, EffectParams params);

/// Checks begin and end of `params` with defaults filled in: a fade without a known end, attack and
/// fade longer than the duration, a "finish" that is too long. nullopt: valid.
std::optional<RpcError> check_end(const EffectParams& params);

/// Checks the times of key frames; nullopt: valid.
std::optional<RpcError> check_keyframes(const std::vector<Keyframe>& keyframes);

}  // namespace hedgehog::protocol
