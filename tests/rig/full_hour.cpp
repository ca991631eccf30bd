// SPDX-License-Identifier: MIT
#include <algorithm>
#include <vector>

#include "tests/rig/hours.h"
#include "tests/rig/random_requests.h"
#include "tests/rig/thermal_ball.h"

namespace hedgehog::rig {
namespace {

using control::EffectId;
using model::Tick;

/// 5 L/R, with L 20 % above nominal, and two ticks of delay.
constexpr Tick kDecay = 23;

struct Client {
  Temper temper;
  Tick next = 0;
  EffectId effect = 0;
  model::EffectSpec spec;
};

/// Starts, updates, replaces or stops an effect; returns 1 for a start.
std::uint64_t act(Rig& rig, Client& client, model::RandomStream& random) {
  const std::uint64_t choice = random.bits() % 8;
  const double pause_s = exponential(random, client.temper.mean_pause_s);
  client.next = rig.now() + 1 + static_cast<Tick>(1000.0 * pause_s);
  if (rig.playing(client.effect)) {
    if (choice == 0) {
      rig.stop(client.effect, control::EndReason::kDisconnected);
      return 0;
    }
    if (choice == 1) {
      rig.stop(client.effect);
      return 0;
    }
    if (choice <= 4) {
      client.spec.strength_a = random.uniform(0.0, 15.0);
      rig.update(client.effect, client.spec);
      return 0;
    }
  }
  const EffectId replaces = choice == 5 && rig.playing(client.effect) ? client.effect : 0;
  client.spec = random_effect(random, client.temper);
  const EffectId started = rig.start(client.spec, replaces);
  if (started == 0) return 0;
  client.effect = started;
  // The next request comes approximately when this effect ends, earlier or later.
  client.next += static_cast<Tick>(random.uniform(0.3, 1.1) *
                                   static_cast<double>(client.spec.duration + client.spec.lease));
  return 1;
}

}  // namespace

HourResult full_hour(std::uint64_t seed, double seconds, const device::FrontEndChoice& front_end,
                     double hand) {
  model::RandomStream random(seed);
  RigOptions options;
  options.board = random_board(random);
  options.board.front_end = front_end;
  options.board.plant.core_to_ambient_fan_k_w *= hand;
  options.board.plant.core_to_ambient_still_k_w *= hand;
  options.control.start.winding_c.fill(options.board.start_c);
  options.control.start.core_c = options.board.start_c;
  options.control.start_ambient_c = options.board.ambient_c;
  Rig rig(options);
  rig.run_until_armed();
  std::vector<Client> clients(1 + random.bits() % 4);
  for (Client& client : clients) client.temper = Temper::draw(random);

  HourResult result;
  std::uint64_t derated = 0;
  Tick silent = 0;
  const auto ticks = static_cast<Tick>(seconds * 1000.0);
  const auto fail = [&](std::string what) {
    result.failure = std::move(what) + " at tick " + std::to_string(rig.now()) + ", hottest " +
                     std::to_string(result.hottest_c) + " C";
  };
  for (Tick i = 0; i < ticks && result.failure.empty(); ++i) {
    for (Client& client : clients)
      if (rig.now() >= client.next) result.effects += act(rig, client, random);
    rig.tick();
    if (i % 4096 == 0) rig.clear_events();
    if (rig.controller().derating()) ++derated;
    result.hottest_c = std::max(result.hottest_c, rig.plant().hottest_winding_c());
    const std::string skin =
        follow_skin(result, rig.plant().skin_c(), static_cast<double>(i) * model::kTickSeconds);
    if (!skin.empty()) fail(skin);
    silent = rig.controller().effects_empty() ? silent + 1 : 0;
    if (silent > kDecay && rig.current_a() > 0.1) fail("a coil was driven though nothing played");
    if (rig.controller().state() != control::State::kArmed) {
      fail("not armed: " +
           words({rig.controller().reason(), rig.controller().last_trip().disagreement}));
    }
  }
  if (result.failure.empty() && result.hottest_c > kHottestAllowedC) fail("too hot");
  result.derated = static_cast<double>(derated) / static_cast<double>(ticks);
  return result;
}

}  // namespace hedgehog::rig
