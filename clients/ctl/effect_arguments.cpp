// SPDX-License-Identifier: MIT
#include "clients/ctl/effect_arguments.h"

#include <CLI/CLI.hpp>

#include "clients/ctl/effect_options.h"
#include "clients/sound/analyser.h"

namespace hedgehog::client {

namespace {

/// `left` as well as `--direction left`.
CLI::Option* add_argument(CLI::App& command, const EffectOption& option, std::string& value) {
  return command.add_option(option.flag + "," + option.parameter, value, option.help)
      ->type_name(option.values);
}

void add_option(CLI::App& command, const EffectOption& option, PlayOptions& options) {
  const std::string& name = option.parameter;
  if (name == "direction" || name == "rotate_to") {
    add_argument(command, option, options.direction);
  } else if (name == "pattern") {
    add_argument(command, option, options.pattern);
  } else if (option.type == protocol::FieldType::kBoolean) {
    command.add_flag(option.flag, options.loop, option.help);
  } else {
    command
        .add_option_function<std::string>(
            option.flag,
            [&options, name](const std::string& text) { options.params.emplace_back(name, text); },
            option.help)
        ->type_name(option.values);
  }
}

void add_sound_options(CLI::App& command, SoundOptions& options) {
  constexpr double kMaxFactor = 100.0;
  command
      .add_option("--pulses", options.pulses, "of a sound file: multiplies its pushes; 0 for none")
      ->check(CLI::Range(0.0, kMaxFactor));
  command
      .add_option("--vibration", options.vibration,
                  "of a sound file: multiplies its vibration; 0 for none")
      ->check(CLI::Range(0.0, kMaxFactor));
  command
      .add_option("--low-hz", options.low_hz,
                  "of a sound file: what is below vibrates, what is above pushes")
      ->check(CLI::Range(sound::kMinLowHz, sound::kMaxLowHz))
      ->capture_default_str();
}

}  // namespace

void add_effect_arguments(CLI::App& command, model::EffectMethod method, PlayOptions& options) {
  using enum model::EffectMethod;
  for (const EffectOption& option : effect_options(method)) add_option(command, option, options);
  if (method == kPulse || method == kHold) command.get_option("--direction")->required();
  CLI::Option* hold =
      command.add_option("--for", options.hold_s, "renewed for this time, then it ends")
          ->type_name("SECONDS");
  if (method == kPlay) {
    hold->needs(command.get_option("--loop"));
    add_sound_options(command, options.sound);
    const CLI::Option* pattern = command.get_option("--pattern");
    const CLI::Option* keyframes = command.get_option("--keyframes");
    command.parse_complete_callback([pattern, keyframes] {
      if (pattern->count() + keyframes->count() == 0)
        throw CLI::RequiredError("pattern or --keyframes");
    });
  }
}

}  // namespace hedgehog::client
