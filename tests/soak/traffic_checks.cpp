// SPDX-License-Identifier: MIT
// Invariants that hold when nothing is pending.
#include <cmath>
#include <set>
#include <string>
#include <utility>

#include "tests/soak/failure.h"
#include "tests/soak/traffic.h"

namespace hedgehog::soak {

bool Traffic::is_settled() const {
  bool settled = watcher_.pending() == 0;
  for_each_peer([&](const Peer& peer) {
    if (peer.is_open() && peer.close_reason().empty())
      settled =
          settled && peer.pending() == 0 && peer.unsent_bytes() == 0 && !peer.is_half_closed();
  });
  return settled;
}

void Traffic::check() {
  for_each_peer([&](Peer& peer) {
    peer.read(true);
    peer.complete_line();
    // Peers that wait for a web page, or for a close that they provoked.
    if (!peer.close_reason().empty()) peer.close();
  });
  pump_until([&] { return is_settled(); }, [&] { return text(); });
  check_connections();
  check_limits();
  check_slot();
  end_effects();
  if (!e2e::RawClient(daemon_.socket()).call("ping").contains("time_ns"))
    throw Failure("a new client gets no answer to its ping");
  ++summary_.checks;
}

void Traffic::check_connections() {
  std::set<std::int64_t> expected{*watcher_.number(), call("hello")["connection"]};
  for_each_peer([&](const Peer& peer) {
    if (!peer.is_open()) return;
    if (!peer.number()) throw Failure("a client without a number: " + peer.text());
    expected.insert(*peer.number());
  });
  e2e::Json listed;
  const auto is_right = [&] {
    listed = call("connection.list")["connections"];
    std::set<std::int64_t> present;
    bool effects_are_owned = true;
    std::set<std::pair<std::int64_t, std::string>> slots;
    for (const e2e::Json& one : listed) {
      present.insert(one["connection"].get<std::int64_t>());
      constexpr std::size_t kMaxEffects = 32;
      if (one["effects"].size() > kMaxEffects) throw Failure("too many effects: " + one.dump());
      for (const e2e::Json& effect : one["effects"]) {
        const bool has_slot = effect["slot"].is_string();
        const bool is_only_one =
            !has_slot || slots.emplace(effect["connection"], effect["slot"]).second;
        effects_are_owned =
            effects_are_owned && is_only_one && effect["connection"] == one["connection"];
      }
    }
    const e2e::Json effects = call("device.status")["effects"];
    for (const e2e::Json& effect : effects)
      effects_are_owned = effects_are_owned && expected.contains(effect["connection"]);
    return present == expected && effects_are_owned;
  };
  pump_until(is_right, [&] {
    return "that only " + std::to_string(expected.size()) +
           " clients and their effects are left: " + listed.dump();
  });
}

void Traffic::check_limits() {
  control_.send(R"([{"jsonrpc":"2.0","id":"h","method":"hello"},)"
                R"({"jsonrpc":"2.0","id":"s","method":"device.status"},)"
                R"({"jsonrpc":"2.0","id":"d","method":"device.describe"}])"
                "\n");
  const e2e::Json responses = control_.response();
  const e2e::Json limits = responses[0]["result"]["limits"];
  const double limit_a = responses[1]["result"]["limit_a"];
  const double current_a = limits["current_a"];
  if (limit_a > current_a || limit_a < 0.0 || limits["continuous_a"] > current_a ||
      limits["felt_a"] > current_a || responses[2]["result"]["limits"]["current_a"] != current_a)
    throw Failure("limits that contradict each other: " + responses[0].dump() +
                  responses[1].dump());
  constexpr double kRounding = 1e-6;
  if (std::fabs(current_a - current_a_) > kRounding)
    throw Failure("limits.current_a is " + std::to_string(current_a) + ", configured is " +
                  std::to_string(current_a_));
}

void Traffic::check_slot() {
  const e2e::Json held =
      call("effect.hold", {{"slot", "check"}, {"direction", "up"}, {"lease_ms", 10'000}});
  if (!held.contains("effect")) return;  // not armed, or claimed
  const auto number = held["effect"].get<std::uint32_t>();
  effects_.admitted(number);
  const auto is_listed = [&] {
    // A lease in device time may have expired on a busy machine.
    if (effects_.has_ended(number)) return true;
    for (const e2e::Json& effect : call("device.status")["effects"])
      if (effect["effect"] == number) return effect["slot"] == "check";
    return false;
  };
  pump_until(is_listed, [] { return std::string("the effect in its slot"); });
  const e2e::Json stopped = call("effect.stop", {{"slot", "check"}});
  pump_until([&] { return effects_.has_ended(number); },
             [&] { return "the end of the effect in its slot: " + stopped.dump(); });
}

void Traffic::end_effects() {
  call("effect.stop_all", {{"scope", "all"}});
  const auto is_over = [&] {
    return effects_.active().empty() && call("device.status")["effects"].empty();
  };
  pump_until(is_over, [&] { return "the end of effects" + effects_.active(); });
}

}  // namespace hedgehog::soak
