// SPDX-License-Identifier: MIT
#include "clients/lib/discovery/choice.h"

#include <algorithm>
#include <functional>
#include <iterator>
#include <string>

namespace hedgehog::client {
namespace {

/// Balls listed in an error.
constexpr std::size_t kMaxListedBalls = 8;

std::vector<DiscoveredBall> select_balls(
    const std::vector<DiscoveredBall>& balls,
    const std::function<bool(const DiscoveredBall&)>& condition) {
  std::vector<DiscoveredBall> some;
  std::copy_if(balls.begin(), balls.end(), std::back_inserter(some), condition);
  return some;
}

bool has_tls(const DiscoveredBall& ball) { return ball.address.tls; }

/// `"ball-7" (serial 0007, tls://192.0.2.7:7586), ...`; `balls` are sorted by name.
std::string listed_balls(const std::vector<DiscoveredBall>& balls) {
  std::string text;
  std::size_t count = 0;
  for (std::size_t i = 0; i < balls.size(); ++i) {
    const DiscoveredBall& ball = balls[i];
    if (i > 0 && balls[i - 1].name == ball.name) continue;
    if (++count > kMaxListedBalls) continue;
    text += std::string(text.empty() ? "" : ", ") + '"' + ball.name + "\" (" +
            (ball.serial ? "serial " + *ball.serial + ", " : "") + to_string(ball.address) + ")";
  }
  if (count > kMaxListedBalls) text += ", and " + std::to_string(count - kMaxListedBalls) + " more";
  return text;
}

ClientError not_found(std::string message) { return {Failure::kNoDaemon, std::move(message), {}}; }

}  // namespace

std::vector<DiscoveredBall> named_balls(std::string_view name,
                                        const std::vector<DiscoveredBall>& balls) {
  const auto by_name = [&](const DiscoveredBall& ball) {
    return has_tls(ball) && ball.name == name;
  };
  const auto by_serial = [&](const DiscoveredBall& ball) {
    return has_tls(ball) && ball.serial == name;
  };
  auto found = select_balls(balls, by_name);
  return found.empty() ? select_balls(balls, by_serial) : found;
}

Outcome<std::vector<DiscoveredBall>> chosen_ball(std::string_view name,
                                                 const std::vector<DiscoveredBall>& balls) {
  const auto all = select_balls(balls, has_tls);
  auto meant = name.empty() ? all : named_balls(name, balls);
  if (all.empty()) return not_found("no ball answers on this network (mDNS, 1 s)");
  if (meant.empty()) {
    return not_found("no ball \"" + std::string(name) +
                     "\" answers on this network (mDNS, 1 s); there are: " + listed_balls(all));
  }
  const bool several = std::any_of(meant.begin(), meant.end(), [&](const DiscoveredBall& ball) {
    return ball.name != meant[0].name;
  });
  if (several) {
    return not_found("several balls answer on this network: " + listed_balls(meant) +
                     "; choose one by its name or serial number, for example mdns://" +
                     meant[0].name);
  }
  return meant;
}

}  // namespace hedgehog::client
