// SPDX-License-Identifier: MIT
// A named pattern: key frames with their waveform. Format of `pattern.put`, `pattern.get` and the
// files in config/patterns.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "protocol/values/effect_params.h"
#include "protocol/wire/fields.h"

namespace hedgehog::protocol {

inline constexpr std::size_t kMaxPatternBytes = 65'536;
inline constexpr std::int64_t kMaxDescription = 256;
inline constexpr Spec kPatternName{.min = 1, .max = kMaxPatternName};

struct Pattern {
  /// "heartbeat" for shipped patterns, else "vendor/name": lower-case letters, digits, `_`, `-` and
  /// `.`, at most 32 on each side of the slash, a letter or digit first.
  std::string name{};
  std::string description{};  // one sentence, at most 256 characters
  /// Defaults for `effect.play`.
  std::optional<model::Waveform> waveform{};
  std::optional<double> frequency_hz{};  // 0.5..250
  std::optional<double> on_fraction{};   // 0.05..0.95
  std::vector<Keyframe> keyframes{};     // 1..256
  void describe(Fields& f);
  friend bool operator==(const Pattern&, const Pattern&) = default;
};

enum class PatternOwner : std::uint8_t { kShipped, kVendor };
/// Owner by the form of the name; nullopt: not a valid pattern name.
std::optional<PatternOwner> owner_of(std::string_view name) noexcept;

/// -32008 "pattern: there is no 'hartbeat'; did you mean 'heartbeat'?"
RpcError no_such_pattern(std::string_view field, std::string_view name,
                         const std::vector<std::string_view>& known);

/// A pattern from its JSON; same checks as `pattern.put`, but accepts any owner's name.
Result<Pattern> decode_pattern(std::string_view json);
/// One line of JSON, without LF.
std::string encode_pattern(const Pattern& pattern);

}  // namespace hedgehog::protocol
