// SPDX-License-Identifier: MIT
// The currents requested by one to four clients at each moment, for the rig of 20 ms.
#pragma once

#include <algorithm>
#include <vector>

#include "tests/rig/random_requests.h"

namespace hedgehog::rig {

class RandomPlay {
 public:
  /// The sum of all peaks, and the largest ratio of rms to peak.
  struct RequestedCurrents {
    model::Vec3 peak_a;
    double rms = 0.0;
  };

  explicit RandomPlay(std::uint64_t seed) : random_(seed) {
    players_.resize(1 + random_.bits() % 4);
    for (Player& player : players_) player.temper = Temper::draw(random_);
  }

  RequestedCurrents at(double now_s) {
    RequestedCurrents requested;
    for (Player& player : players_) {
      if (now_s >= player.until_s) turn(player, now_s);
      if (!player.playing) continue;
      requested.peak_a = requested.peak_a + player.peak_a;
      requested.rms = std::max(requested.rms, player.rms);
    }
    return requested;
  }

  std::uint64_t effects() const noexcept { return effects_; }

 private:
  struct Player {
    Temper temper;
    double until_s = 0.0;  // end of the effect, or of the pause
    bool playing = false;
    model::Vec3 peak_a;
    double rms = 1.0;
  };

  void turn(Player& player, double now_s) {
    player.playing = !player.playing;
    if (!player.playing) {
      player.until_s = now_s + exponential(random_, player.temper.mean_pause_s);
      return;
    }
    const model::EffectSpec spec = random_effect(random_, player.temper);
    player.peak_a = spec.strength_a * spec.trajectory.direction;
    player.rms = rms_fraction(spec);
    player.until_s = now_s + 1e-3 * static_cast<double>(spec.duration + spec.lease);
    ++effects_;
  }

  model::RandomStream random_;
  std::vector<Player> players_;
  std::uint64_t effects_ = 0;
};

}  // namespace hedgehog::rig
