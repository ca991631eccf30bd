// SPDX-License-Identifier: MIT
// Many clients that receive telemetry, from one thread.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "tests/bench/load/client.h"

namespace hedgehog::bench {

/// Three fields, 100 times per second.
inline constexpr int kSubscribedHz = 100;

struct Received {
  std::size_t notifications = 0;
  /// Missing notifications between received ones, by their device time.
  std::size_t missing = 0;
  double seconds = 0.0;
};

class Subscribers {
 public:
  /// Connects and subscribes.
  Subscribers(int port, std::size_t count);
  Subscribers(const Subscribers&) = delete;
  Subscribers& operator=(const Subscribers&) = delete;
  ~Subscribers();

  /// Reads for `seconds`.
  Received run(double seconds);

 private:
  struct Subscriber {
    Client client;
    std::string rest;  // incomplete line
    std::int64_t last_ns = 0;
  };
  void read(Subscriber& from, Received& received);

  std::vector<Subscriber> all_;
  std::string bytes_;
  int poll_;
};

}  // namespace hedgehog::bench
