// SPDX-License-Identifier: MIT
#include "clients/ctl/tunnel/located_ball.h"

#include <boost/asio/co_spawn.hpp>
#include <boost/asio/use_awaitable.hpp>

namespace hedgehog::client {

namespace asio = boost::asio;

asio::awaitable<BallStream::Opened> LocatedBall::open() {
  if (!needs_search(addresses_)) co_return co_await BallStream::open(addresses_);
  // Blocks, which must not delay the other clients.
  const auto search = [this, now = Clock::now()]() -> asio::awaitable<BallSearch::Located> {
    co_return search_begun_after(now);
  };
  const auto located = co_await asio::co_spawn(searches_, search, asio::use_awaitable);
  if (!located) co_return located.error();
  co_return co_await BallStream::open(*located);
}

BallSearch::Located LocatedBall::search_begun_after(Clock::time_point requested) {
  if (!found_ || begun_ < requested) {
    begun_ = Clock::now();
    found_ = locate(addresses_);
  }
  return *found_;
}

}  // namespace hedgehog::client
