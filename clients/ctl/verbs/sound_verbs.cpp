// SPDX-License-Identifier: MIT
#include "clients/ctl/verbs/sound_verbs.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "clients/common/interrupts.h"
#include "clients/ctl/patterns/pattern_file.h"
#include "clients/ctl/terminal/bar.h"
#include "clients/ctl/terminal/words.h"
#include "clients/ctl/verbs/sound_player.h"
#include "clients/sound/slices.h"

namespace hedgehog::client {

namespace {

using nlohmann::json;
using sound::Slice;

/// Parameters that apply to every slice.
constexpr std::array<std::string_view, 6> kForAll{"level", "current_a", "force_n",
                                                  "gain",  "frame",     "priority"};
constexpr std::array<std::string_view, 3> kForVibration{"waveform", "frequency_hz", "on_fraction"};

bool among(std::string_view name, const auto& names) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// An option that does not apply to sounds; empty: none.
std::string misplaced_option(const PlayOptions& options) {
  if (options.loop) return "--loop";
  if (options.hold_s) return "--for";
  for (const auto& given : options.params)
    if (!among(given.first, kForAll) && !among(given.first, kForVibration)) {
      std::string flag = "--" + given.first;
      std::replace(flag.begin(), flag.end(), '_', '-');
      return flag;
    }
  return {};
}

/// The fraction of the requested strength below which nothing is felt.
double felt_part(const json& params, const protocol::HelloResult& hello) {
  const auto& limits = hello.limits;
  double strength_a = limits.continuous_a;
  if (params.contains("current_a") && params["current_a"].is_number())
    strength_a = params["current_a"].get<double>();
  else if (params.contains("level") && params["level"].is_number())
    strength_a = params["level"].get<double>() * limits.current_a;
  else if (params.contains("force_n"))
    return 0.0;  // only the daemon can convert it to a current
  return strength_a > limits.felt_a ? limits.felt_a / strength_a : 0.0;
}

Outcome<PlayableSound> prepare(Session& session, const PlayOptions& options) {
  auto file = sound::SoundFile::open(options.pattern);
  if (!file) return file.error();
  auto hello = session.connection.hello("hedgehogctl");
  if (!hello) return hello.error();
  PlayOptions without_file = options;
  without_file.pattern.clear();
  const auto text = play_params(without_file);
  if (!text) return text.error();
  json params = json::parse(*text);
  json of_vibration = json::object();
  of_vibration["waveform"] = "sine";
  for (const std::string_view name : kForVibration) {
    const auto given = params.find(name);
    if (given == params.end()) continue;
    of_vibration[std::string(name)] = *given;
    params.erase(given);
  }
  const sound::SliceOptions slices{options.sound.low_hz, options.sound.pulses,
                                   options.sound.vibration, felt_part(params, *hello)};
  return PlayableSound{sound::SliceReader(*std::move(file), slices), params.dump(),
                       of_vibration.dump()};
}

int refuse_option(const std::string& option) {
  return report_usage_error("hedgehogctl: " + option + " does not go with a sound file");
}

/// The direction of the strongest key frame, for users.
std::string side_of(const Slice& slice) {
  double azimuth = 0.0;
  double most = 0.0;
  for (const auto* frames : {&slice.vibration, &slice.pulses})
    for (const protocol::Keyframe& frame : *frames)
      if (frame.level > most) {
        most = frame.level;
        azimuth = std::get<protocol::Angles>(*frame.direction).azimuth_deg;
      }
  if (most <= 0.0) return "";
  return azimuth > 30.0 ? "left" : azimuth < -30.0 ? "right" : "front";
}

double mean_level(const Slice& slice) {
  double sum = 0.0;
  for (const protocol::Keyframe& frame : slice.vibration) sum += frame.level;
  return slice.vibration.empty() ? 0.0 : sum / static_cast<double>(slice.vibration.size());
}

}  // namespace

bool is_sound_file(const std::string& text) {
  std::string lower = text;
  std::transform(lower.begin(), lower.end(), lower.begin(), [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  });
  for (const char* ending : {".wav", ".flac", ".ogg", ".oga", ".aiff", ".aif", ".mp3"})
    if (lower.ends_with(ending)) return names_a_file(text);
  return false;
}

int run_sound(Session& session, const PlayOptions& options) {
  if (const std::string option = misplaced_option(options); !option.empty())
    return refuse_option(option);
  auto prepared = prepare(session, options);
  if (!prepared) return report_error(prepared.error());
  SoundPlayer player(session, *prepared, options.pattern);
  const auto complete = player.play();
  if (!complete) {
    if (session.style.cuts && !session.json) std::puts("");
    return report_error(complete.error());
  }
  player.print_end(*complete);
  if (!*complete) return kInterrupted;
  return player.all_completed() ? kDone : kEndedOtherwise;
}

int run_sound_preview(Session& session, const PlayOptions& options) {
  if (const std::string option = misplaced_option(options); !option.empty())
    return refuse_option(option);
  auto prepared = prepare(session, options);
  if (!prepared) return report_error(prepared.error());
  if (!session.json)
    std::puts("  time   pushes   vibration                                      towards");
  while (const auto slice = prepared->reader.next()) {
    if (interrupted()) return kInterrupted;
    if (session.json) {
      for (const std::string& text : effects_of(*slice, *prepared)) {
        json params = json::parse(text);
        params["at_ms"] = slice->start_ms;
        std::puts(params.dump().c_str());
      }
      continue;
    }
    const double level = mean_level(*slice);
    const std::string vibration =
        level > 0.0 ? bar(level, 0.0, 1.0, {}, session.style.ascii) +
                          fmt::format(" {:3.0f} %  {:3.0f} Hz", 100.0 * level, slice->frequency_hz)
                    : std::string();
    std::printf("%6.1f   %6zu   %s   %s\n", static_cast<double>(slice->start_ms) / 1000.0,
                pushes_in(*slice), left(vibration, 44).c_str(), side_of(*slice).c_str());
  }
  return kDone;
}

}  // namespace hedgehog::client
