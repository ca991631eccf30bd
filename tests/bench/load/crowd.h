// SPDX-License-Identifier: MIT
// Clients that ask one request after another.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "tests/bench/load/client.h"

namespace hedgehog::bench {

/// One round trip after another: the duration of each, s.
std::vector<double> round_trips(const std::function<void()>& one, double seconds);

/// Many clients, from one thread. Each has `in_flight` requests under way: what is answered is sent
/// again.
class Crowd {
 public:
  /// Connects, and has the first answer to each.
  Crowd(int port, std::size_t clients, std::size_t in_flight, std::string_view request = kPing);
  Crowd(const Crowd&) = delete;
  Crowd& operator=(const Crowd&) = delete;
  ~Crowd();

  /// So many answers came in `seconds`.
  std::size_t run(double seconds);

 private:
  std::vector<Client> clients_;
  std::size_t request_bytes_;
  std::string requests_;  // as many as may be under way
  int poll_;
};

}  // namespace hedgehog::bench
