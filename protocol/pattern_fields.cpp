// SPDX-License-Identifier: MIT
#include <algorithm>

#include "protocol/describe.h"
#include "protocol/json.h"
#include "protocol/pattern.h"
#include "protocol/reader.h"
#include "protocol/writer.h"

namespace hedgehog::protocol {
namespace {

constexpr std::size_t kMaxPart = 32;
constexpr Spec kName{.min = 1, .max = kMaxPatternName};

bool is_word(char c) noexcept { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9'); }

bool is_part(std::string_view part) noexcept {
  return !part.empty() && part.size() <= kMaxPart && is_word(part.front()) &&
         std::all_of(
             part.begin(), part.end(),
             [](char c) { return is_word(c) || c == '_' || c == '-' || c == '.'; });
}

}  // namespace

std::optional<PatternOwner> owner_of(std::string_view name) noexcept {
  const std::size_t slash = name.find('/');
  if (slash == std::string_view::npos)
    return is_part(name) ? std::optional(PatternOwner::kShipped) : std::nullopt;
  return is_part(name.substr(0, slash)) && is_part(name.substr(slash + 1))
             ? std::optional(PatternOwner::kVendor)
             : std::nullopt;
}

void describe(Fields& f, Pattern& v) {
  f.required("name", v.name, kName);
  f.defaulted("description", v.description, {.max = kMaxDescription}, !v.description.empty());
  f.optional("waveform", v.waveform);
  f.optional("frequency_hz", v.frequency_hz, {.min = 0.5, .max = 250});
  f.optional("on_fraction", v.on_fraction, {.min = 0.05, .max = 0.95});
  f.required("keyframes", v.keyframes, {.items = model::kMaxKeyframes});
  if (!f.checks()) return;
  if (!owner_of(v.name)) {
    RpcError error = invalid_params(
        "name", "'" + shortened(v.name) +
                    "' is no name for a pattern; say vendor/name in lower case, like acme/knock");
    error.value = shortened(v.name);
    f.fail(std::move(error));
  }
  if (auto wrong = check_keyframes(v.keyframes)) f.fail(*std::move(wrong));
}

void describe(Fields& f, PatternPut& v) { describe(f, v.pattern); }
void describe(Fields& f, PatternGet& v) { f.required("name", v.name, kName); }
void describe(Fields& f, PatternRemove& v) { f.required("name", v.name, kName); }

void describe(Fields& f, PatternSummary& v) {
  f.required("name", v.name);
  f.required("description", v.description);
  f.required("duration_ms", v.duration_ms);
  f.required("keyframes", v.keyframes);
  f.required("shipped", v.shipped);
}

void describe(Fields& f, PatternsResult& v) { f.required("patterns", v.patterns); }

void describe(Fields& f, PatternResult& v) {
  describe(f, v.pattern);
  f.required("duration_ms", v.duration_ms);
  f.required("shipped", v.shipped);
}

RpcError no_such_pattern(std::string_view field, std::string_view name,
                         const std::vector<std::string_view>& known) {
  RpcError made = error(ErrorCode::kNoSuchPattern, std::string(field) + ": there is no '" +
                                                       shortened(name) + "'" + hint(name, known));
  made.field = std::string(field);
  made.value = shortened(name);
  return made;
}

Result<Pattern> decode_pattern(std::string_view json) {
  constexpr std::size_t kNesting = 8;
  const Result<Json> parsed = parse_json(json, kNesting);
  if (!parsed) return parsed.error();
  Pattern pattern;
  Reader reader(*parsed, Reader::Strictness::kStrict, "a pattern");
  reader.value(pattern);
  if (reader.error()) return *reader.error();
  return pattern;
}

std::string encode_pattern(const Pattern& pattern) {
  std::string out;
  append(out, pattern);
  return out;
}

}  // namespace hedgehog::protocol
