// SPDX-License-Identifier: MIT
// A search for balls on the network: one question by multicast DNS to each IPv4 network of this
// machine. HEDGEHOG_MDNS_PORT, for tests: that port is asked instead, on this machine only.
#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <vector>

#include "clients/lib/client_error.h"
#include "clients/lib/discovery/discovered_ball.h"

namespace hedgehog::client {

/// How long the search for an address of mdns:// takes; that for a name ends when it is found.
inline constexpr std::chrono::milliseconds kSearchTime{1000};

/// The balls that answer within `time`, by name; one that has several addresses is there with
/// each. Waits for the whole time. kNoDaemon: this machine has no network. Any thread.
Outcome<std::vector<DiscoveredBall>> discover(std::chrono::milliseconds time = kSearchTime);

/// Whether there is an address of mdns:// among them.
bool needs_search(const std::vector<Address>& addresses);

/// A search for what the addresses of mdns:// mean. One thread at a time; starts none.
class BallSearch {
 public:
  using Located = Outcome<std::vector<Address>>;

  /// REQUIRES: `needs_search(addresses)`. Begins at once and does not wait.
  explicit BallSearch(std::vector<Address> addresses);
  ~BallSearch();
  BallSearch(BallSearch&&) noexcept;
  BallSearch& operator=(BallSearch&&) noexcept;

  /// The same addresses with what was found, once the search is over, which it is after
  /// `kSearchTime`; nullopt: not by `deadline` (one in the past does not wait). kNoDaemon: no ball,
  /// or more than one, is meant. kBadAddress: one of mdns:// has no fingerprint.
  std::optional<Located> located(std::chrono::steady_clock::time_point deadline);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// The same, waiting for it; `addresses` themselves where there is nothing to search for.
BallSearch::Located locate(const std::vector<Address>& addresses);

}  // namespace hedgehog::client
