// SPDX-License-Identifier: MIT
#include "protocol/values/pattern.h"

#include <algorithm>

#include "protocol/wire/json.h"
#include "protocol/wire/reader.h"
#include "protocol/wire/writer.h"

namespace hedgehog::protocol {
namespace {

constexpr std::size_t kMaxPart = 32;

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

void Pattern::describe(Fields& f) {
  f.required("name", name, kPatternName);
  f.defaulted("description", description, {.max = kMaxDescription}, !description.empty());
  f.optional("waveform", waveform);
  f.optional("frequency_hz", frequency_hz, {.min = 0.5, .max = 250});
  f.optional("on_fraction", on_fraction, {.min = 0.05, .max = 0.95});
  f.required("keyframes", keyframes, {.items = model::kMaxKeyframes});
  if (!f.checks()) return;
  if (!owner_of(name)) {
    RpcError error = invalid_params(
        "name",
        "'" + shortened(name) +
            "' is not a valid pattern name; use vendor/name in lower case, like acme/knock");
    error.value = shortened(name);
    f.fail(std::move(error));
  }
  if (auto wrong = check_keyframes(keyframes)) f.fail(*std::move(wrong));
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
