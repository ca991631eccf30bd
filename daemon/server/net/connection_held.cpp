// SPDX-License-Identifier: MIT
// Requests of a connection that are held while its client does not read its responses.
#include <spdlog/spdlog.h>

#include <boost/asio/co_spawn.hpp>
#include <boost/asio/detached.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/redirect_error.hpp>
#include <boost/asio/use_awaitable.hpp>
#include <exception>
#include <utility>

#include "daemon/server/net/connection.h"

namespace hedgehog::server {

namespace asio = boost::asio;
using boost::system::error_code;

bool Connection::held_back() const noexcept {
  return held_back_by_bytes() || server_.pending(session_) > kMaxPending;
}

bool Connection::full() const noexcept {
  return !write_ended_ &&
         (held_bytes_ > max_held_bytes_ || server_.pending(session_) > 2 * kMaxPending);
}

void Connection::hold(Held line) {
  // An empty line uses memory too.
  held_bytes_ += line.bytes();
  held_.push_back(std::move(line));
  session_.held = held_.size();
  serve();
}

void Connection::bypass_held(std::string_view text) {
  session_.bypassed = 0;
  execute(text, received_ns_);
  session_.bypassed = held_.size();
}

void Connection::execute(std::string_view text, std::int64_t received_ns) {
  session_.received_ns = received_ns;
  server_.line(session_, text);
}

void Connection::serve_next() {
  const Held line = std::move(held_.front());
  held_.pop_front();
  held_bytes_ -= line.bytes();
  if (line.too_long)
    server_.line_too_long(session_);
  else
    execute(line.text, line.received_ns);
  session_.held = held_.size();
  if (session_.bypassed > 0) --session_.bypassed;
  capacity_.cancel();
}

void Connection::serve() {
  if (serving_ || served_) return;
  asio::co_spawn(
      executor_,
      [](std::shared_ptr<Connection> self) -> asio::awaitable<void> {
        co_await self->serve_held();
      }(shared_from_this()),
      asio::detached);
  serving_ = true;
}

asio::awaitable<void> Connection::serve_held() {
  try {
    // Not within the turn that held a request, nor while responses are removed from the list that
    // `held_back` reads.
    co_await asio::post(executor_, asio::use_awaitable);
    begin_turn();
    co_await serve_all();
  } catch (const std::exception& e) {
    spdlog::error("connection {} ends: {}", session_.id, e.what());
    abort();
  }
  held_.clear();
  session_.held = session_.bypassed = 0;
  serving_ = false;
  capacity_.cancel();
}

asio::awaitable<void> Connection::serve_all() {
  while (!aborted_) {
    if (held_back() && !write_ended_) {
      end_turn();
      co_await wait_for_reader();
      begin_turn();
    } else if (!held_.empty()) {
      serve_next();
      co_await yield_turn();
    } else {
      break;
    }
  }
  end_turn();
}

asio::awaitable<void> Connection::wait_for_reader() {
  std::size_t unread = 0;
  const auto restart = [&] {
    sent_part_ = false;
    unread = unread_bytes();
    progress_.expires_after(write_timeout_);
  };
  restart();
  while (!aborted_ && !write_ended_ && held_back()) {
    error_code woken;
    co_await progress_.async_wait(asio::redirect_error(asio::use_awaitable, woken));
    if (woken && !sent_part_) continue;
    // The system has its own send buffer, and signals writability only when much of it is free.
    const bool waits = queue_.response_bytes() > allowed_response_bytes();
    if (!waits || sent_part_ || unread_bytes() < unread) {
      restart();
    } else if (!aborted_) {
      report_not_reading();
      abort();
    }
  }
}

}  // namespace hedgehog::server
