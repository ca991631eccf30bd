// SPDX-License-Identifier: MIT
// The clients' actions of a soak, one random action after the other.
#pragma once

#include <cstdint>
#include <string>

#include "tests/soak/random.h"
#include "tests/soak/request_generator.h"
#include "tests/soak/traffic.h"

namespace hedgehog::soak {

/// Configuration of a start, and its current limit.
struct Configuration {
  std::string json;
  double current_a = 15.0;
};
Configuration random_configuration(Random& random);

class Actions {
 public:
  /// `random` is also the generator's: it is reseeded at each action, so that an action's draws
  /// depend only on `seed` and the action's number, not on earlier responses of the daemon.
  Actions(Random& random, RequestGenerator& generator, Traffic& traffic, std::uint64_t seed);

  void act();
  /// From now on no action arms the ball.
  void disable_arming() noexcept { arms_ = false; }

 private:
  Peer& random_peer();
  Transport any_transport();
  void send(Peer& peer, const std::string& message);
  void requests();
  void batches();
  void damaged_line();
  void long_line();
  void partial_line();
  void new_client();
  void disconnect();
  void flood();
  void read_again();
  void subscribe();
  void web_page();
  void web_frames();
  void foreign_client();
  void reload();
  void repair_ball();

  Random& random_;
  RequestGenerator& generator_;
  Traffic& traffic_;
  std::uint64_t seed_;
  std::uint64_t count_ = 0;
  bool arms_ = true;
};

}  // namespace hedgehog::soak
