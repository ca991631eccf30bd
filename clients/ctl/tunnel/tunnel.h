// SPDX-License-Identifier: MIT
// A port of 127.0.0.1 whose clients reach a ball on the network: the tunnel verifies the daemon and
// sends the token, so that games need neither TLS nor a secret.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "clients/common/problem.h"
#include "clients/lib/address.h"
#include "clients/lib/client_error.h"

namespace hedgehog::client {

/// One thread; a search for an mdns:// address has a thread of its own. Each client has its own
/// connection to the ball, made when it sends its first bytes, and ends with it.
class Tunnel {
 public:
  struct Limits {
    /// A further one is closed. The daemon has 64 by default.
    int clients = 32;
    /// A client that has sent nothing after this time is closed.
    std::chrono::milliseconds first_request{std::chrono::minutes(1)};
    /// So is one that does not read what is sent to it.
    std::chrono::milliseconds write{std::chrono::minutes(1)};
  };
  /// Receives the reason why a client was closed, or none is accepted; each once until another
  /// client reaches the ball. The client receives it as an error without an id.
  using Report = std::function<void(const ClientError&)>;

  /// REQUIRES: each address has TLS, mdns:// included.
  Tunnel(std::vector<Address> addresses, Report report);
  Tunnel(std::vector<Address> addresses, Report report, const Limits& limits);
  Tunnel(const Tunnel&) = delete;
  Tunnel& operator=(const Tunnel&) = delete;
  /// Closes all connections. Blocks while a search ends, for `kSearchTime` at most, and while the
  /// system's resolver looks for a host's name.
  ~Tunnel();

  /// Listens on that port of 127.0.0.1, 0: any free one; returns it.
  Result<std::uint16_t> listen(std::uint16_t port);
  /// REQUIRES: `listen` has returned a port. Serves until SIGINT, SIGTERM or SIGHUP.
  void run();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace hedgehog::client
