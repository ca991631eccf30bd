// SPDX-License-Identifier: MIT
// Waits for a time, or for an event that is signalled by cancelling a timer.
#pragma once

#include <boost/asio/awaitable.hpp>
#include <boost/asio/redirect_error.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/asio/use_awaitable.hpp>
#include <boost/system/error_code.hpp>

namespace hedgehog::server {

/// Returns when `timer` expires or is cancelled. io thread.
inline boost::asio::awaitable<void> wait(boost::asio::steady_timer& timer) {
  boost::system::error_code ignored;
  co_await timer.async_wait(boost::asio::redirect_error(boost::asio::use_awaitable, ignored));
}

}  // namespace hedgehog::server
