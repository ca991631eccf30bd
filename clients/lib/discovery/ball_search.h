// SPDX-License-Identifier: MIT
// Search for balls on the network: one multicast DNS query to each IPv4 network of this machine.
// HEDGEHOG_MDNS_PORT, for tests: the query goes to that port instead, on this machine only.
#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <vector>

#include "clients/lib/client_error.h"
#include "clients/lib/discovery/discovered_ball.h"

namespace hedgehog::client {

/// Duration of a search for an mdns:// address; a search for a name ends when it is found.
inline constexpr std::chrono::milliseconds kSearchTime{1000};

/// The balls that answer within `time`, by name, once for each of their addresses. Blocks for the
/// whole time. kNoDaemon: this machine has no network. Any thread.
Outcome<std::vector<DiscoveredBall>> discover(std::chrono::milliseconds time = kSearchTime);

/// True if `addresses` contains an mdns:// address.
bool needs_search(const std::vector<Address>& addresses);

/// Resolves mdns:// addresses. One thread at a time; starts none.
class BallSearch {
 public:
  using Located = Outcome<std::vector<Address>>;

  /// REQUIRES: `needs_search(addresses)`. Starts the search and does not block.
  explicit BallSearch(std::vector<Address> addresses);
  ~BallSearch();
  BallSearch(BallSearch&&) noexcept;
  BallSearch& operator=(BallSearch&&) noexcept;

  /// The addresses with mdns:// resolved, once the search has ended, after `kSearchTime` at most;
  /// nullopt: not by `deadline` (one in the past does not block). kNoDaemon: no ball or more than
  /// one matches. kBadAddress: an mdns:// address without a fingerprint.
  std::optional<Located> located(std::chrono::steady_clock::time_point deadline);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// The same, blocking; returns `addresses` unchanged where no search is needed.
BallSearch::Located locate(const std::vector<Address>& addresses);

}  // namespace hedgehog::client
