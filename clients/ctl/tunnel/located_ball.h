// SPDX-License-Identifier: MIT
// The addresses of a tunnel's ball, searched for on the network where they are mdns:// addresses.
#pragma once

#include <boost/asio/awaitable.hpp>
#include <boost/asio/thread_pool.hpp>
#include <chrono>
#include <optional>
#include <vector>

#include "clients/ctl/tunnel/ball_stream.h"
#include "clients/lib/discovery/ball_search.h"

namespace hedgehog::client {

/// Connections of one io thread; the search has a thread of its own.
class LocatedBall {
 public:
  /// REQUIRES: each address has TLS, mdns:// included.
  explicit LocatedBall(std::vector<Address> addresses) : addresses_(std::move(addresses)) {}
  LocatedBall(const LocatedBall&) = delete;
  LocatedBall& operator=(const LocatedBall&) = delete;
  /// Blocks while a search ends, for `kSearchTime` at most.
  ~LocatedBall() = default;

  /// A connection, after a search where one is needed. Clients that wait at the same time share a
  /// search, so that the last of them waits for two of them at most. Errors as of
  /// `BallStream::open` and `BallSearch::located`.
  boost::asio::awaitable<BallStream::Opened> open();

 private:
  using Clock = std::chrono::steady_clock;

  BallSearch::Located search_begun_after(Clock::time_point requested);

  const std::vector<Address> addresses_;
  // Of the search thread.
  Clock::time_point begun_;
  std::optional<BallSearch::Located> found_;
  // The last member: it ends before what it uses.
  boost::asio::thread_pool searches_{1};
};

}  // namespace hedgehog::client
