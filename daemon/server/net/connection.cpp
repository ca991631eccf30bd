// SPDX-License-Identifier: MIT
#include "daemon/server/net/connection.h"

#include <spdlog/spdlog.h>

#include <boost/asio/co_spawn.hpp>
#include <boost/asio/detached.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/redirect_error.hpp>
#include <boost/asio/use_awaitable.hpp>
#include <exception>
#include <utility>

namespace hedgehog::server {
namespace {

namespace asio = boost::asio;
using boost::system::error_code;

constexpr std::chrono::seconds kCloseTimeout{1};
/// So long one client is served before the others get their turn.
constexpr std::chrono::milliseconds kTurn{1};

}  // namespace

Connection::Connection(asio::any_io_executor executor, Server& server, Session session,
                       std::size_t queue_bytes)
    : executor_(std::move(executor)),
      server_(server),
      session_(std::move(session)),
      queue_(queue_bytes),
      wake_(executor_, asio::steady_timer::time_point::max()),
      pending_timer_(executor_, asio::steady_timer::time_point::max()),
      close_timer_(executor_) {
  session_.sink = this;
}

void Connection::start() {
  asio::co_spawn(
      executor_,
      [](std::shared_ptr<Connection> self) -> asio::awaitable<void> {
        co_await self->run();
      }(shared_from_this()),
      asio::detached);
}

asio::awaitable<void> Connection::run() {
  server_.open(session_);
  spdlog::info("connection {} from {}", session_.id, session_.address.value_or(session_.transport));
  asio::co_spawn(
      executor_,
      [](std::shared_ptr<Connection> self) -> asio::awaitable<void> {
        co_await self->write();
      }(shared_from_this()),
      asio::detached);
  try {
    co_await read();
  } catch (const std::exception& e) {
    spdlog::error("connection {} ends: {}", session_.id, e.what());
  }
  server_.close(session_);
  while (!finishing_) {
    error_code release;
    co_await pending_timer_.async_wait(asio::redirect_error(asio::use_awaitable, release));
  }
  // At a shutdown the listener finishes who is still owed an answer.
  server_.forget(session_);
  spdlog::info("connection {} closed{}", session_.id,
               session_.client.empty() ? "" : " (" + session_.client + ")");
}

void Connection::finish() {
  if (finishing_) return;
  finishing_ = true;
  pending_timer_.cancel();
  wake_.cancel();
  close_timer_.expires_after(kCloseTimeout);
  close_timer_.async_wait([self = shared_from_this()](error_code ec) {
    if (!ec) self->abort();
  });
}

void Connection::send(std::string line, LineKind kind) {
  if (finishing_ && kind == LineKind::kTelemetry) return;
  const std::uint64_t dropped = queue_.telemetry_dropped();
  const bool fits = queue_.push(std::move(line), kind);
  counters().telemetry_dropped += queue_.telemetry_dropped() - dropped;
  if (fits) {
    wake_.cancel();
  } else if (!aborted_) {
    spdlog::warn("connection {} ({}) does not read; disconnected", session_.id,
                 session_.client.empty() ? session_.transport : session_.client);
    ++counters().rejected["slow"];
    aborted_ = true;
    asio::post(executor_, [self = shared_from_this()] { self->abort(); });
  }
}

void Connection::abort() noexcept {
  aborted_ = true;
  close();
  wake_.cancel();
}

asio::awaitable<bool> Connection::take(std::string_view text) {
  if (!aborted_) server_.line(session_, text);
  co_return co_await next_turn();
}

asio::awaitable<bool> Connection::too_long() {
  if (!aborted_) server_.line_too_long(session_);
  co_return co_await next_turn();
}

void Connection::begin_turn() noexcept { turn_ends_ = std::chrono::steady_clock::now() + kTurn; }

asio::awaitable<bool> Connection::next_turn() {
  if (std::chrono::steady_clock::now() > turn_ends_) {
    co_await asio::post(executor_, asio::use_awaitable);
    begin_turn();
  }
  co_return !aborted_;
}

asio::awaitable<void> Connection::write() {
  error_code ec;
  while (!ec && !aborted_) {
    if (queue_.empty()) {
      if (finishing_) break;
      error_code woken;
      co_await wake_.async_wait(asio::redirect_error(asio::use_awaitable, woken));
      continue;
    }
    ec = co_await send_next(queue_);
    queue_.sent();
  }
  if (!ec && !aborted_) co_await finish_stream();
  close_timer_.cancel();
  close();
}

}  // namespace hedgehog::server
