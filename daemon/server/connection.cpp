// SPDX-License-Identifier: MIT
#include "daemon/server/connection.h"

#include <spdlog/spdlog.h>

#include <array>
#include <boost/asio/buffer.hpp>
#include <boost/asio/co_spawn.hpp>
#include <boost/asio/detached.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/redirect_error.hpp>
#include <boost/asio/use_awaitable.hpp>
#include <boost/asio/write.hpp>
#include <chrono>
#include <exception>
#include <utility>

#include "daemon/server/line_reader.h"
#include "protocol/server_codec.h"

namespace hedgehog::server {
namespace {

namespace asio = boost::asio;
using boost::system::error_code;

constexpr std::size_t kReadBytes = 16 * 1024;
constexpr std::chrono::seconds kFarewell{1};
/// So long one client is served before the others get their turn.
constexpr std::chrono::milliseconds kTurn{1};

}  // namespace

Connection::Connection(Socket socket, Server& server, Session session, std::size_t queue_bytes)
    : socket_(std::move(socket)),
      server_(server),
      session_(std::move(session)),
      queue_(queue_bytes),
      wake_(socket_.get_executor(), asio::steady_timer::time_point::max()),
      owed_(socket_.get_executor(), asio::steady_timer::time_point::max()),
      farewell_(socket_.get_executor()) {
  session_.sink = this;
}

void Connection::start() {
  const auto run = [](std::shared_ptr<Connection> self) -> asio::awaitable<void> {
    self->server_.open(self->session_);
    spdlog::info("connection {} from {}", self->session_.id,
                 self->session_.address.value_or(self->session_.transport));
    asio::co_spawn(
        self->socket_.get_executor(),
        [](std::shared_ptr<Connection> me) -> asio::awaitable<void> { co_await me->write(); }(self),
        asio::detached);
    try {
      co_await self->read();
    } catch (const std::exception& e) {
      spdlog::error("connection {} ends: {}", self->session_.id, e.what());
    }
    self->server_.close(self->session_);
    while (!self->finishing_) {
      error_code let_go;
      co_await self->owed_.async_wait(asio::redirect_error(asio::use_awaitable, let_go));
    }
    // At a shutdown the listener finishes who is still owed an answer.
    self->server_.forget(self->session_);
    spdlog::info("connection {} closed{}", self->session_.id,
                 self->session_.client.empty() ? "" : " (" + self->session_.client + ")");
  };
  asio::co_spawn(socket_.get_executor(), run(shared_from_this()), asio::detached);
}

void Connection::finish() {
  if (finishing_) {
    return;
  }
  finishing_ = true;
  owed_.cancel();
  wake_.cancel();
  farewell_.expires_after(kFarewell);
  farewell_.async_wait([self = shared_from_this()](error_code ec) {
    if (!ec) {
      self->abort();
    }
  });
}

void Connection::send(std::string line, LineKind kind) {
  if (finishing_ && kind == LineKind::kTelemetry) {
    return;
  }
  if (!queue_.push(std::move(line), kind)) {
    if (!aborted_) {
      spdlog::warn("connection {} ({}) does not read; disconnected", session_.id,
                   session_.client.empty() ? session_.transport : session_.client);
      aborted_ = true;
      asio::post(socket_.get_executor(), [self = shared_from_this()] { self->abort(); });
    }
    return;
  }
  wake_.cancel();
}

void Connection::abort() noexcept {
  aborted_ = true;
  error_code ignored;
  socket_.close(ignored);
  wake_.cancel();
}

asio::awaitable<bool> Connection::take_lines(LineReader& reader) {
  auto turn_ends = std::chrono::steady_clock::now() + kTurn;
  while (const auto line = reader.next()) {
    if (aborted_) {
      co_return false;
    }
    if (line->too_long) {
      server_.line_too_long(session_);
    } else {
      server_.line(session_, line->text);
    }
    if (std::chrono::steady_clock::now() > turn_ends) {
      co_await asio::post(socket_.get_executor(), asio::use_awaitable);
      turn_ends = std::chrono::steady_clock::now() + kTurn;
    }
  }
  co_return true;
}

asio::awaitable<void> Connection::read() {
  LineReader reader(protocol::kMaxLineBytes);
  std::array<char, kReadBytes> buffer;
  bool known = false;
  for (;;) {
    error_code ec;
    const std::size_t count = co_await socket_.async_read_some(
        asio::buffer(buffer), asio::redirect_error(asio::use_awaitable, ec));
    if (ec) {
      co_return;
    }
    reader.feed({buffer.data(), count});
    if (!known && reader.first_byte()) {
      known = true;
      // Web pages can reach loopback, and what a browser sends begins with a letter.
      if (*reader.first_byte() != '{' && *reader.first_byte() != '[') {
        spdlog::warn("connection {} does not speak JSON-RPC; closed", session_.id);
        co_return;
      }
    }
    if (!co_await take_lines(reader)) {
      co_return;
    }
  }
}

asio::awaitable<void> Connection::write() {
  const auto self = shared_from_this();
  error_code ec;
  while (!ec && !aborted_) {
    if (queue_.empty()) {
      if (finishing_) {
        break;
      }
      error_code woken;
      co_await wake_.async_wait(asio::redirect_error(asio::use_awaitable, woken));
      continue;
    }
    co_await asio::async_write(socket_, asio::buffer(queue_.take()),
                               asio::redirect_error(asio::use_awaitable, ec));
    queue_.sent();
  }
  farewell_.cancel();
  error_code ignored;
  socket_.shutdown(Socket::shutdown_both, ignored);
  socket_.close(ignored);
}

}  // namespace hedgehog::server
