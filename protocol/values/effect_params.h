// SPDX-License-Identifier: MIT
// The parameters of the methods that play (protocol/README.md),
// as they were said: what was left out is nullopt. Decoding checks every range that does not depend
// on the ball; the server checks the rest: current_a and force_n against limits.current_a, role
// `operate` for priority 8 and 9 and for frame "coil", the kind of end and the circle's parameters
// in `effect.update`, pins that do not exist.
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

/// One of a pattern; see model::Keyframe.
struct Keyframe {
  std::int64_t t_ms = 0;                 // 0..60 000, not before the one before it
  std::optional<Direction> direction{};  // as the one before it; of the first: front
  double level = 0.0;                    // 0..1
  std::optional<model::Ease> ease{};     // linear
  void describe(Fields& f);
  friend bool operator==(const Keyframe&, const Keyframe&) = default;
};

/// Times are milliseconds; fractions were rounded to whole control ticks.
struct EffectParams {
  std::optional<Direction> direction{};
  std::optional<model::Frame> frame{};

  /// At most one of the three. level 0..1 of limits.current_a; the others are not negative.
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

  /// The parameters of a start; nullopt: of an update.
  void describe(Fields& f, std::optional<model::EffectMethod> method);
  friend bool operator==(const EffectParams&, const EffectParams&) = default;
};

inline constexpr std::int64_t kMaxDurationMs = 10'000;
inline constexpr std::int64_t kMinLeaseMs = 100;
inline constexpr std::int64_t kMaxLeaseMs = 10'000;
inline constexpr std::int64_t kMaxFinishMs = 2'000;
inline constexpr std::int64_t kMaxSlotCharacters = 32;
inline constexpr std::int64_t kMaxPatternName = 65;

/// `params` with everything filled in that `method` has a default for. Still open afterwards: the
/// strength (none = limits.continuous_a), the start, the slot, and `direction` of pulse and hold
/// (decoding refuses them without one). Vibrate and circle end after 1000 ms when neither
/// duration_ms nor lease_ms is said, a loop by its lease of 1000 ms; a pattern that does not loop
/// then ends with its last key frame, which is left open.
EffectParams with_defaults(model::EffectMethod method, EffectParams params);

/// What is wrong with how `params`, defaults filled in, begin and end: a fade without a known end,
/// attack and fade longer than the whole, a "finish" that is too long. nullopt: nothing.
std::optional<RpcError> check_end(const EffectParams& params);

/// What is wrong with the times of key frames; nullopt: nothing.
std::optional<RpcError> check_keyframes(const std::vector<Keyframe>& keyframes);

}  // namespace hedgehog::protocol
