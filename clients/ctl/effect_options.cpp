// SPDX-License-Identifier: MIT
#include "clients/ctl/effect_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "protocol/methods/effect.h"

namespace hedgehog::client {

namespace {

using protocol::FieldInfo;
using protocol::FieldType;

/// The protocol's bounds are printed before the text.
constexpr std::array<std::pair<std::string_view, std::string_view>, 31> kHelp{{
    {"direction", "where the pins push out: left, 34 (a pin), 90,20 (azimuth, elevation), 0,1,0.5"},
    {"pattern", "heartbeat, acme/knock, or a file: .json, .ahap, .hjif, .wav ..."},
    {"keyframes", "instead of a pattern: a JSON list of {\"t_ms\", \"level\", \"direction\"}"},
    {"rotate_to", "what the pattern's front turns to: left, 34, 90,20 ..."},
    {"rate", "speed, times that of the pattern"},
    {"loop", "repeats it until Ctrl-C"},
    {"axis", "axis of the circle; default up"},
    {"ring_deg", "angle from the axis"},
    {"speed_pins_s", "steps a second"},
    {"sense", "seen from outside along the axis"},
    {"stepping", "from pin to pin, or gliding"},
    {"frame", "what a direction refers to; coil: the windings' axes (operate)"},
    {"level", "strength, of the ball's limit"},
    {"current_a", "strength in ampere (5 for ever, 15 for about 22 s)"},
    {"force_n", "strength in newton at the nearest pin"},
    {"gain", "multiplies the strength"},
    {"start_at_ns", "device time at which it begins, 10 s ahead at most"},
    {"delay_ms", "time before it begins"},
    {"attack_ms", "linear rise at the beginning"},
    {"fade_ms", "linear fall at the end"},
    {"attack_level", "where the rise begins, of the strength"},
    {"fade_level", "where the fall ends, of the strength"},
    {"waveform", "how the strength changes in each period"},
    {"frequency_hz", "of the waveform"},
    {"on_fraction", "of a square wave"},
    {"duration_ms", "ends after this time"},
    {"lease_ms",
     "instead of a duration: renewed until Ctrl-C; ends this long after the last renewal"},
    {"on_close", "when the connection ends; finish: at most 2000 ms"},
    {"slot", "a name for it; the next one of that name replaces it"},
    {"priority", "only effects of the highest are output (8, 9: operate)"},
    {"if_limited", "when the ball is too warm"},
}};

std::string help_of(std::string_view parameter) {
  const auto* const found = std::find_if(kHelp.begin(), kHelp.end(),
                                         [&](const auto& one) { return one.first == parameter; });
  return found == kHelp.end() ? std::string() : std::string(found->second);
}

std::string bounds_of(const protocol::Spec& spec) {
  // The limits of the C++ types are not bounds.
  constexpr double kUnbounded = 1e15;
  if (spec.max > kUnbounded) return "NUMBER";
  return fmt::format("{:g}..{:g}", spec.min, spec.max);
}

std::string values_of(const FieldInfo& field) {
  switch (field.type) {
    case FieldType::kBoolean:
      return "";
    case FieldType::kNumber:
      return bounds_of(field.spec);
    case FieldType::kEnumerator: {
      std::string values;
      for (const std::string_view name : field.names)
        values += (values.empty() ? "" : "|") + std::string(name);
      return values;
    }
    case FieldType::kDirection:
      return "DIRECTION";
    case FieldType::kText:
      return "NAME";
    case FieldType::kList:
    case FieldType::kObject:
      return "JSON";
  }
  return "";
}

}  // namespace

std::string flag_of(std::string_view parameter) {
  std::string flag = "--" + std::string(parameter);
  std::replace(flag.begin(), flag.end(), '_', '-');
  return flag;
}

std::vector<EffectOption> effect_options(model::EffectMethod method) {
  std::vector<EffectOption> options;
  protocol::EffectStart start{.method = method};
  for (const FieldInfo& field :
       protocol::list_fields([&](protocol::Fields& fields) { start.describe(fields); })) {
    options.push_back(
        {field.name, flag_of(field.name), values_of(field), help_of(field.name), field.type});
  }
  return options;
}

}  // namespace hedgehog::client
