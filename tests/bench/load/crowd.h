// SPDX-License-Identifier: MIT
// Clients that send one request after another.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "tests/bench/load/client.h"

namespace hedgehog::bench {

/// Repeated round trips: the duration of each, s.
std::vector<double> round_trips(const std::function<void()>& one, double seconds);

/// Many clients, from one thread. Each has `in_flight` pending requests: a request whose response
/// has arrived is sent again.
class Crowd {
 public:
  /// Connects, and waits for the first response to each client.
  Crowd(int port, std::size_t clients, std::size_t in_flight, std::string_view request = kPing);
  Crowd(const Crowd&) = delete;
  Crowd& operator=(const Crowd&) = delete;
  ~Crowd();

  /// The number of responses received in `seconds`.
  std::size_t run(double seconds);

 private:
  std::vector<Client> clients_;
  std::size_t request_bytes_;
  std::string requests_;  // `in_flight` requests
  int poll_;
};

}  // namespace hedgehog::bench
