// SPDX-License-Identifier: MIT
#include "clients/ctl/verbs/sound_player.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "clients/common/interrupts.h"

namespace hedgehog::client {

namespace {

using nlohmann::json;
using sound::Slice;

constexpr std::int64_t kNsPerMs = 1'000'000;
constexpr std::int64_t kStartNs = 300 * kNsPerMs;
constexpr std::int64_t kLookaheadNs = 2000 * kNsPerMs;
constexpr Milliseconds kTimePoll{50};
constexpr double kTimeHz = 20.0;

/// "1:05".
std::string clock_words(double seconds) {
  const auto whole = static_cast<long>(std::max(0.0, seconds));
  return fmt::format("{}:{:02}", whole / 60, whole % 60);
}

}  // namespace

std::vector<std::string> effects_of(const Slice& slice, const PlayableSound& sound) {
  std::vector<std::string> effects;
  const auto add = [&](const std::vector<protocol::Keyframe>& frames, const json& more) {
    if (frames.empty()) return;
    json params = json::parse(sound.params);
    protocol::Pattern pattern;
    pattern.keyframes = frames;
    params["keyframes"] = json::parse(protocol::encode_pattern(pattern))["keyframes"];
    params.update(more);
    effects.push_back(params.dump());
  };
  add(slice.pulses, json::object());
  json wave = json::object();
  wave["frequency_hz"] = slice.frequency_hz;
  wave.update(json::parse(sound.of_vibration));
  add(slice.vibration, wave);
  return effects;
}

std::size_t pushes_in(const Slice& slice) { return slice.pulses.size() / 2; }

SoundPlayer::SoundPlayer(Session& session, PlayableSound& sound, std::string name)
    : session_(session), sound_(sound), name_(std::move(name)) {}

Outcome<bool> SoundPlayer::play() {
  if (auto begun = begin(); !begun) return begun.error();
  std::optional<Slice> slice = sound_.reader.next();
  while (slice || now_ns_ < end_ns_ || !playing_.empty()) {
    if (interrupted()) return false;
    while (slice && start_ns_ + slice->start_ms * kNsPerMs < now_ns_ + kLookaheadNs) {
      // The last telemetry is outdated if this program was stopped meanwhile (Ctrl-Z).
      if (auto read = read_clock(); !read) return read.error();
      if (auto sent = send(*slice); !sent) return sent.error();
      slice = sound_.reader.next();
    }
    if (auto read = follow(); !read) return read.error();
  }
  return true;
}

void SoundPlayer::print_end(bool complete) const {
  if (session_.json) {
    std::puts(json{{"played_ms", played_ms()},
                   {"pulses", pushes_},
                   {"slices", slices_},
                   {"late_slices", late_slices_},
                   {"reason", complete ? reason() : "interrupted"}}
                  .dump()
                  .c_str());
    return;
  }
  if (session_.style.cuts) std::printf("\r\x1b[K");
  std::printf(
      "%s   %s   %s   %s%s%s\n", name_.c_str(),
      clock_words(static_cast<double>(played_ms()) / 1000.0).c_str(), counted_pushes().c_str(),
      complete ? reason().c_str() : "interrupted",
      late_slices_ > 0
          ? fmt::format(", {} of {} slices late and left out", late_slices_, slices_).c_str()
          : "",
      limited_by_.empty() ? "" : (", limited by " + limited_by_).c_str());
}

std::string SoundPlayer::reason() const {
  return other_reason_.empty() ? "completed" : other_reason_;
}
std::string SoundPlayer::counted_pushes() const {
  return fmt::format("{} push{}", pushes_, pushes_ == 1 ? "" : "es");
}

std::int64_t SoundPlayer::played_ms() const {
  return std::clamp<std::int64_t>((now_ns_ - start_ns_) / kNsPerMs, 0,
                                  static_cast<std::int64_t>(sound_.reader.seconds() * 1000.0));
}

Outcome<void> SoundPlayer::begin() {
  if (auto events = session_.connection.call(protocol::EventsSubscribe{{"effect_ended"}}); !events)
    return events.error();
  protocol::StatusKeys only_time;
  only_time.add(protocol::StatusKey::kTimeNs);
  if (auto sent = session_.connection.call(protocol::TelemetrySubscribe{kTimeHz, only_time}); !sent)
    return sent.error();
  if (auto read = read_clock(); !read) return read.error();
  start_ns_ = now_ns_ + kStartNs;
  end_ns_ = start_ns_ + static_cast<std::int64_t>(sound_.reader.seconds() * 1e9);
  return {};
}

Outcome<void> SoundPlayer::read_clock() {
  const auto time = session_.connection.call(protocol::Ping{});
  if (!time) return time.error();
  now_ns_ = time->time_ns;
  return {};
}

Outcome<void> SoundPlayer::send(const Slice& slice) {
  ++slices_;
  const std::int64_t at_ns = start_ns_ + slice.start_ms * kNsPerMs;
  // The daemon starts a time in the past at once, overlapping the following slices.
  if (at_ns < now_ns_) {
    ++late_slices_;
    return {};
  }
  pushes_ += pushes_in(slice);
  for (const std::string& text : effects_of(slice, sound_)) {
    json params = json::parse(text);
    params["start_at_ns"] = at_ns;
    const auto response = session_.connection.call_raw("effect.play", params.dump());
    if (!response) return response.error();
    const auto admission = protocol::decode_result<protocol::Admission>(*response);
    if (!admission) return ClientError{Failure::kProtocol, admission.error().message, {}};
    playing_.insert(admission->effect);
    // Two simultaneous effects limit each other where they add up, which is intended.
    if (admission->limited_by && *admission->limited_by != "mix")
      limited_by_ = *admission->limited_by;
    if (!session_.json) continue;
    std::puts(response->c_str());
    std::fflush(stdout);
  }
  return {};
}

Outcome<void> SoundPlayer::follow() {
  for (Milliseconds timeout = kTimePoll;; timeout = Milliseconds(0)) {
    const auto notification = session_.connection.next(timeout);
    if (!notification) return notification.error();
    if (!*notification) break;
    take(**notification);
  }
  print_progress();
  return {};
}

void SoundPlayer::take(const Notification& notification) {
  if (const auto* event = std::get_if<protocol::EventMessage>(&notification)) {
    if (event->event.effect && playing_.erase(*event->event.effect) > 0 &&
        event->event.reason != "completed")
      other_reason_ = event->event.reason.value_or("ended");
    return;
  }
  const auto& telemetry = std::get<protocol::TelemetryMessage>(notification).telemetry;
  now_ns_ = std::max(now_ns_, telemetry.status.time_ns);
}

void SoundPlayer::print_progress() const {
  if (session_.style.cuts && !session_.json) {
    std::printf("\r%s   %s of %s   %s\x1b[K", name_.c_str(),
                clock_words(static_cast<double>(played_ms()) / 1000.0).c_str(),
                clock_words(sound_.reader.seconds()).c_str(), counted_pushes().c_str());
    std::fflush(stdout);
  }
}

}  // namespace hedgehog::client
