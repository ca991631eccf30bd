// SPDX-License-Identifier: MIT
#include "clients/ctl/effect_arguments.h"

#include "cli/program.h"
#include "clients/ctl/effect_options.h"
#include "clients/sound/analyser.h"

namespace hedgehog::client {

namespace {

/// `left` as well as `--direction left`.
cli::OptionSpec add_argument(const cli::CommandSpec& command, const EffectOption& option,
                             std::string& value) {
  return command.add_option(option.flag + "," + option.parameter, value, option.help)
      .type_name(option.values);
}

void add_option(const cli::CommandSpec& command, const EffectOption& option, PlayOptions& options) {
  const std::string& name = option.parameter;
  if (name == "direction" || name == "rotate_to") {
    add_argument(command, option, options.direction);
  } else if (name == "pattern") {
    add_argument(command, option, options.pattern);
  } else if (option.type == protocol::FieldType::kBoolean) {
    command.add_flag(option.flag, options.loop, option.help);
  } else {
    command
        .add_option_function(
            option.flag,
            [&options, name](const std::string& text) { options.params.emplace_back(name, text); },
            option.help)
        .type_name(option.values);
  }
}

void add_sound_options(const cli::CommandSpec& command, SoundOptions& options) {
  constexpr double kMaxFactor = 100.0;
  command
      .add_option("--pulses", options.pulses, "of a sound file: multiplies its pushes; 0 for none")
      .range(0.0, kMaxFactor);
  command
      .add_option("--vibration", options.vibration,
                  "of a sound file: multiplies its vibration; 0 for none")
      .range(0.0, kMaxFactor);
  command
      .add_option("--low-hz", options.low_hz,
                  "of a sound file: what is below vibrates, what is above pushes")
      .range(sound::kMinLowHz, sound::kMaxLowHz)
      .show_default();
}

}  // namespace

void add_effect_arguments(const cli::CommandSpec& command, model::EffectMethod method,
                          PlayOptions& options) {
  using enum model::EffectMethod;
  for (const EffectOption& option : effect_options(method)) add_option(command, option, options);
  if (method == kPulse || method == kHold) command.option("--direction").required();
  const cli::OptionSpec hold =
      command.add_option("--for", options.hold_s, "renewed for this time, then it ends")
          .type_name("SECONDS");
  if (method == kPlay) {
    hold.needs(command.option("--loop"));
    add_sound_options(command, options.sound);
    command.require_any_of(command.option("--pattern"), command.option("--keyframes"),
                           "pattern or --keyframes");
  }
}

}  // namespace hedgehog::client
