// SPDX-License-Identifier: MIT
// A reference server.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "tests/bench/load/child.h"

namespace hedgehog::bench {

/// A server that prints its port.
class Server {
 public:
  explicit Server(std::vector<std::string> words) : process_(std::move(words)) {
    port_ = std::stoi(process_.line_after("listening on 127.0.0.1:"));
  }
  int port() const noexcept { return port_; }
  const Child& process() const noexcept { return process_; }

 private:
  Child process_;
  int port_ = 0;
};

}  // namespace hedgehog::bench
