// SPDX-License-Identifier: MIT
// Start of the coroutines of a tunnel.
#pragma once

#include <boost/asio/awaitable.hpp>
#include <boost/asio/co_spawn.hpp>
#include <exception>
#include <utility>

namespace hedgehog::client {

/// Starts `coroutine`; an exception of it leaves the executor's run().
template <class Executor>
void spawn(Executor&& executor, boost::asio::awaitable<void> coroutine) {
  boost::asio::co_spawn(
      std::forward<Executor>(executor), std::move(coroutine),
      [](const std::exception_ptr& exception) {
        if (exception) std::rethrow_exception(exception);
      });
}

}  // namespace hedgehog::client
