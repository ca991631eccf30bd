// SPDX-License-Identifier: MIT
// Uploaded effects of games, and their playback: commands of the device in, requests to the daemon
// out. Has no clock, input or output of its own; one thread.
#pragma once

#include <linux/input.h>

#include <array>
#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "clients/gamepad/effect_translation.h"
#include "protocol/methods.h"

namespace hedgehog::gamepad {

using TimePoint = std::chrono::steady_clock::time_point;

/// Every effect plays in a slot of its own, "ff0" to "ff15". An effect of at most 10 s ends in the
/// daemon by its duration; a longer one has a lease of 500 ms that is renewed here. Playback ends
/// after kMaxPlay, repetitions included, unless it is uploaded or started again.
class EffectPlayer {
 public:
  static constexpr int kMaxEffects = 16;
  static constexpr Milliseconds kLease{500};
  static constexpr Milliseconds kRenewAfter{150};

  explicit EffectPlayer(const TranslationOptions& options) : options_(options) {}

  /// 0, or the errno of the game's ioctl: EINVAL for an effect that cannot be translated or an
  /// invalid id. An effect playing under the same id is replaced and restarted.
  int upload(const ff_effect& effect, TimePoint now);
  /// Also ends it. 0 or EINVAL.
  int erase(std::int64_t id, TimePoint now);
  /// Plays it `count` times; 0 or less stops it. Ids without an upload are ignored.
  void play(std::int64_t id, std::int32_t count, TimePoint now);
  /// Gain of all effects, 0..0xffff, until the next call.
  void set_gain(std::int32_t gain);

  /// Starts, renews and ends the effects that are due at `now`.
  void advance(TimePoint now);
  /// When `advance` must be called next; nullopt: nothing plays.
  std::optional<TimePoint> deadline() const;
  /// Requests in the order in which they must be sent; each is returned once.
  std::vector<protocol::Request> take_requests();

  /// After a new connection, on which no effect plays. `felt_level` as in TranslationOptions.
  void on_connect(double felt_level);
  bool is_playing(std::int64_t id) const;

 private:
  struct Effect {
    std::optional<ff_effect> uploaded;
    TranslatedEffect translated;
    std::int32_t repetitions = 0;  // remaining; 0: it does not play
    bool started = false;          // sent to the daemon; false: in its delay
    bool leased = false;
    TimePoint begins{};
    TimePoint ends{};
    TimePoint renew{};
    TimePoint stop_at{};  // kMaxPlay
  };

  Effect* find(std::int64_t id);
  static std::string slot(const Effect& effect, const std::array<Effect, kMaxEffects>& all);
  void schedule(Effect& effect, TimePoint from) const;
  void advance(Effect& effect, TimePoint now);
  void start(Effect& effect);
  void end_repetition(Effect& effect, TimePoint now);
  void stop(Effect& effect);
  TimePoint next_step(const Effect& effect) const;

  TranslationOptions options_;
  double gain_ = 1.0;
  std::array<Effect, kMaxEffects> effects_{};
  std::vector<protocol::Request> requests_;
};

}  // namespace hedgehog::gamepad
