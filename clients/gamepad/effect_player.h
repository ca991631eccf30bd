// SPDX-License-Identifier: MIT
// What games have uploaded, and what of it plays: commands of the device in, requests to the daemon
// out. No clock, no input or output of its own; one thread.
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

/// Every effect plays in a slot of its own, "ff0" to "ff15". One of at most 10 s ends in the daemon
/// by its duration; a longer one has a lease of 500 ms that is renewed here. A play ends after
/// kMaxPlay, repetitions included, unless it is uploaded or started again.
class EffectPlayer {
 public:
  static constexpr int kMaxEffects = 16;
  static constexpr Milliseconds kLease{500};
  static constexpr Milliseconds kRenewAfter{150};

  explicit EffectPlayer(const TranslationOptions& options) : options_(options) {}

  /// 0, or the errno of the game's ioctl: EINVAL for what cannot be translated or has no place.
  /// What plays under the same number becomes the new effect and begins again.
  int upload(const ff_effect& effect, TimePoint now);
  /// Ends it too. 0 or EINVAL.
  int erase(std::int64_t id, TimePoint now);
  /// Plays it `count` times; 0 or less stops it. Numbers that nobody uploaded are ignored.
  void play(std::int64_t id, std::int32_t count, TimePoint now);
  /// Of all effects, 0..0xffff, until it is set again.
  void set_gain(std::int32_t gain);

  /// Begins, renews and ends what is due at `now`.
  void advance(TimePoint now);
  /// When `advance` has something to do next; nullopt: nothing plays.
  std::optional<TimePoint> deadline() const;
  /// In the order in which they are to be sent; they are returned once.
  std::vector<protocol::Request> take_requests();

  /// A new connection: nothing plays there. `felt_level` as in TranslationOptions.
  void on_connect(double felt_level);
  bool is_playing(std::int64_t id) const;

 private:
  struct Effect {
    std::optional<ff_effect> uploaded;
    TranslatedEffect translated;
    std::int32_t repetitions = 0;  // that are left; 0: it does not play
    bool started = false;          // the daemon has it; false: its delay runs
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
