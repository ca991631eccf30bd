// SPDX-License-Identifier: MIT
#include "protocol/wire/names.h"

#include <algorithm>
#include <array>

#include "base/spelling.h"

namespace hedgehog::protocol {
namespace {

constexpr std::array<std::string_view, 3> kRoles{"observe", "play", "operate"};
constexpr std::array<std::string_view, 6> kWords{"up", "down", "left", "right", "front", "back"};
constexpr std::array<std::string_view, 3> kFrames{"device", "world", "coil"};
constexpr std::array<std::string_view, 6> kWaveforms{"constant", "sine",     "square",
                                                     "triangle", "sawtooth", "noise"};
constexpr std::array<std::string_view, 3> kEases{"linear", "step", "smooth"};

/// Names used by other haptics APIs (SDL, evdev, OpenXR, CoreHaptics, W3C).
constexpr std::array<std::pair<std::string_view, std::string_view>, 11> kForeignNames{{
    {"amplitude", "level"},
    {"intensity", "level"},
    {"magnitude", "level"},
    {"strength", "level"},
    {"direction", "axis"},
    {"direction", "rotate_to"},
    {"duty", "on_fraction"},
    {"length", "duration_ms"},
    {"speed", "speed_pins_s"},
    {"speed", "rate"},
    {"id", "effect"},
}};

}  // namespace

Names names_of(Role) noexcept { return kRoles; }
Names names_of(Word) noexcept { return kWords; }
Names names_of(model::Frame) noexcept { return kFrames; }
Names names_of(model::Waveform) noexcept { return kWaveforms; }
Names names_of(model::Ease) noexcept { return kEases; }

std::string_view name(Role role) noexcept { return kRoles[static_cast<std::size_t>(role)]; }
std::string_view name(Word enumerator) noexcept {
  return kWords[static_cast<std::size_t>(enumerator)];
}
std::string_view name(model::Frame frame) noexcept {
  return kFrames[static_cast<std::size_t>(frame)];
}
std::string_view name(model::Waveform waveform) noexcept {
  return kWaveforms[static_cast<std::size_t>(waveform)];
}

std::string_view name(model::Ease ease) noexcept { return kEases[static_cast<std::size_t>(ease)]; }

std::optional<Role> role_named(std::string_view text) noexcept {
  return enumerator_named<Role>(text);
}

std::string_view nearest(std::string_view text, Names names) {
  for (const auto& [foreign, native] : kForeignNames)
    if (foreign == text && std::find(names.begin(), names.end(), native) != names.end())
      return native;
  return base::nearest(text, names);
}

std::string shortened(std::string_view text) {
  constexpr std::size_t kShown = 64;
  if (text.size() <= kShown) return std::string(text);
  std::size_t end = kShown;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0u) == 0x80u) --end;
  return std::string(text.substr(0, end)) + "…";
}

std::string hint(std::string_view text, Names names) {
  if (const std::string_view meant = nearest(text, names); !meant.empty())
    return "; did you mean '" + std::string(meant) + "'?";
  constexpr std::size_t kFew = 8;
  if (names.empty() || names.size() > kFew) return {};
  std::string list = "; there is ";
  for (std::size_t i = 0; i < names.size(); ++i) {
    list += i == 0 ? "" : i + 1 == names.size() ? " and " : ", ";
    list += names[i];
  }
  return list;
}

}  // namespace hedgehog::protocol
