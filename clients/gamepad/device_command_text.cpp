// SPDX-License-Identifier: MIT
#include "clients/gamepad/device_command_text.h"

#include <fmt/format.h>

namespace hedgehog::gamepad {

namespace {

std::string waveform_text(std::uint16_t waveform) {
  switch (waveform) {
    case FF_SINE:
      return "sine";
    case FF_SQUARE:
      return "square";
    case FF_TRIANGLE:
      return "triangle";
    case FF_SAW_UP:
      return "rising sawtooth";
    case FF_SAW_DOWN:
      return "falling sawtooth";
    default:
      return fmt::format("waveform {:#x}", waveform);
  }
}

std::string envelope_text(const ff_envelope& envelope) {
  std::string text;
  if (envelope.attack_length != 0)
    text += fmt::format(", attack {} ms from {}", envelope.attack_length, envelope.attack_level);
  if (envelope.fade_length != 0)
    text += fmt::format(", fade {} ms to {}", envelope.fade_length, envelope.fade_level);
  return text;
}

std::string periodic_text(const ff_effect& effect) {
  const ff_periodic_effect& wave = effect.u.periodic;
  std::string text =
      fmt::format("{} from {:#06x}, {} ms, magnitude {}", waveform_text(wave.waveform),
                  effect.direction, wave.period, wave.magnitude);
  if (wave.offset != 0) text += fmt::format(", offset {}", wave.offset);
  if (wave.phase != 0) text += fmt::format(", phase {:#06x}", wave.phase);
  return text + envelope_text(wave.envelope);
}

std::string force_text(const ff_effect& effect) {
  switch (effect.type) {
    case FF_RUMBLE:
      return fmt::format("rumble, strong {}, weak {}", effect.u.rumble.strong_magnitude,
                         effect.u.rumble.weak_magnitude);
    case FF_PERIODIC:
      return periodic_text(effect);
    case FF_CONSTANT:
      return fmt::format("constant {} from {:#06x}", effect.u.constant.level, effect.direction) +
             envelope_text(effect.u.constant.envelope);
    case FF_RAMP:
      return fmt::format("ramp {} to {} from {:#06x}", effect.u.ramp.start_level,
                         effect.u.ramp.end_level, effect.direction) +
             envelope_text(effect.u.ramp.envelope);
    default:
      return fmt::format("type {:#x}", effect.type);
  }
}

std::string upload_text(const ff_effect& effect) {
  std::string text = fmt::format("upload {}: {}, ", effect.id, force_text(effect));
  text += effect.replay.length == 0 ? "endless" : fmt::format("length {} ms", effect.replay.length);
  if (effect.replay.delay != 0) text += fmt::format(", delay {} ms", effect.replay.delay);
  return text;
}

std::string play_text(const PlayCommand& play) {
  if (play.count <= 0) return fmt::format("stop {}", play.id);
  return fmt::format("play {}, {} time{}", play.id, play.count, play.count == 1 ? "" : "s");
}

}  // namespace

std::string to_text(const DeviceCommand& command) {
  if (const auto* upload = std::get_if<UploadRequest>(&command)) return upload_text(upload->effect);
  if (const auto* erase = std::get_if<EraseRequest>(&command))
    return fmt::format("erase {}", erase->id);
  if (const auto* play = std::get_if<PlayCommand>(&command)) return play_text(*play);
  return fmt::format("gain {}", std::get<GainCommand>(command).gain);
}

}  // namespace hedgehog::gamepad
