// SPDX-License-Identifier: MIT
#include "clients/ctl/play_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <system_error>
#include <utility>

#include "clients/ctl/arguments/direction_argument.h"
#include "clients/ctl/arguments/text_argument.h"
#include "clients/ctl/effect_options.h"
#include "clients/ctl/patterns/pattern_file.h"
#include "model/effect/effect.h"
#include "protocol/methods.h"

namespace hedgehog::client {

namespace {

using nlohmann::json;

constexpr int kHoldLeaseMs = 1000;

/// A parameter as typed: a number if it parses as one, else a string, which the daemon rejects with
/// the parameter's name.
json typed(const std::string& text) {
  const json number = json::parse(text, nullptr, false);
  return number.is_number() || number.is_boolean() ? number : json(text);
}

bool is_given(const PlayOptions& options, std::string_view parameter) {
  return std::any_of(
      options.params.begin(), options.params.end(),
      [&](const auto& given) { return given.first == parameter; });
}

/// A number among the parameters, or `fallback` if it is not given.
std::optional<double> number_of(const PlayOptions& options, std::string_view parameter,
                                double fallback) {
  double number = fallback;
  for (const auto& [name, text] : options.params) {
    if (name != parameter) continue;
    const json value = typed(text);
    if (!value.is_number()) return std::nullopt;
    number = value.get<double>();
  }
  return number;
}

/// The value of a parameter on the wire, as JSON text.
Outcome<std::string> wire_value(protocol::FieldType type, const std::string& name,
                                const std::string& text) {
  switch (type) {
    case protocol::FieldType::kText:
    case protocol::FieldType::kEnumerator:
      return text_json(name, text);
    case protocol::FieldType::kDirection:
      return direction_json(text);
    case protocol::FieldType::kList:
    case protocol::FieldType::kObject:
      if (!json::accept(text)) return ClientError{Failure::kBadAddress, name + ": is not JSON", {}};
      return text;
    case protocol::FieldType::kBoolean:
    case protocol::FieldType::kNumber:
      break;
  }
  const json number = typed(text);
  return number.is_string() ? text_json(name, text) : number.dump();
}

/// An existing file whose name cannot be a pattern's name.
bool is_other_file(const std::string& text) {
  std::error_code ec;
  return !text.empty() && !protocol::owner_of(text) && std::filesystem::is_regular_file(text, ec);
}

/// Duration of the renewals, seconds, of a pattern of `takes_ms` without another end.
std::optional<double> renewal_of(const PlayOptions& options, std::int64_t takes_ms) {
  if (options.held() || is_given(options, "duration_ms")) return options.hold_s;
  // The daemon rejects an invalid rate with its name.
  const auto rate = number_of(options, "rate", 1.0);
  if (!rate || !(*rate > 0.0)) return std::nullopt;
  const double takes = static_cast<double>(takes_ms) / *rate;
  return takes > static_cast<double>(protocol::kMaxDurationMs) ? std::optional(takes / 1000.0)
                                                               : std::nullopt;
}

}  // namespace

Outcome<WithFile> with_file(PlayOptions options) {
  if (!is_pattern_file(options.pattern)) {
    if (!is_other_file(options.pattern)) return WithFile{std::move(options), {}};
    return ClientError{Failure::kBadData,
                       options.pattern +
                           ": plays files ending in .json, .ahap or .hjif (patterns), .wav, .flac, "
                           ".ogg, .oga, .aiff, .aif or .mp3 (sounds)",
                       {}};
  }
  auto read = read_any_pattern(options.pattern);
  if (!read) return read.error();
  options.hold_s = renewal_of(options, read->pattern.keyframes.back().t_ms);
  options.file_pattern = std::move(read->pattern);
  return WithFile{std::move(options), std::move(read->notes)};
}

Outcome<std::string> play_params(const PlayOptions& options) {
  json params = json::object();
  if (!options.direction.empty()) {
    auto direction = direction_json(options.direction);
    if (!direction) return direction.error();
    params[options.method == "effect.play" ? "rotate_to" : "direction"] = json::parse(*direction);
  }
  if (options.file_pattern) {
    params.update(json::parse(protocol::encode_pattern(*options.file_pattern)));
    params.erase("name");
    params.erase("description");
  } else if (!options.pattern.empty()) {
    const auto pattern = text_json("pattern", options.pattern);
    if (!pattern) return pattern.error();
    params["pattern"] = json::parse(*pattern);
  }
  if (options.loop) params["loop"] = true;
  if (options.held()) params["lease_ms"] = kHoldLeaseMs;
  const auto method = protocol::enumerator_named<model::EffectMethod>(options.method);
  const auto known = method ? effect_options(*method) : std::vector<EffectOption>{};
  for (const auto& given : options.params) {
    const std::string& name = given.first;
    const auto option = std::find_if(known.begin(), known.end(),
                                     [&](const auto& one) { return one.parameter == name; });
    const auto type = option == known.end() ? protocol::FieldType::kNumber : option->type;
    const auto value = wire_value(type, name, given.second);
    if (!value) return value.error();
    params[name] = json::parse(*value);
  }
  return params.dump();
}

bool PlayOptions::held() const {
  const bool is_endless = method == "effect.hold" || loop;
  return hold_s || is_given(*this, "lease_ms") || (is_endless && !is_given(*this, "duration_ms"));
}

PlayOptions with_end(PlayOptions options, double pitch_deg) {
  if (options.method != "effect.circle" || options.held() || is_given(options, "duration_ms"))
    return options;
  const protocol::EffectParams defaults = protocol::with_defaults(model::EffectMethod::kCircle, {});
  const auto ring_deg = number_of(options, "ring_deg", *defaults.ring_deg);
  const auto speed_pins_s = number_of(options, "speed_pins_s", *defaults.speed_pins_s);
  // The daemon rejects invalid values with their names.
  if (!ring_deg || !speed_pins_s || !(*speed_pins_s > 0.0)) return options;
  const double round_s = model::circle_steps(*ring_deg, pitch_deg) / *speed_pins_s;
  if (1000.0 * round_s <= static_cast<double>(protocol::kMaxDurationMs))
    options.params.emplace_back("duration_ms", std::to_string(std::llround(1000.0 * round_s)));
  else
    options.hold_s = round_s;
  return options;
}

}  // namespace hedgehog::client
