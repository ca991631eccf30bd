// SPDX-License-Identifier: MIT
#include "daemon/server/net/connection.h"

#include <spdlog/spdlog.h>

#include <algorithm>
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

/// Until `timer` is cancelled.
asio::awaitable<void> wait(asio::steady_timer& timer) {
  error_code cancelled;
  co_await timer.async_wait(asio::redirect_error(asio::use_awaitable, cancelled));
}

}  // namespace

Connection::Connection(asio::any_io_executor executor, Server& server, Session session,
                       const config::ConnectionSettings& settings)
    : executor_(std::move(executor)),
      server_(server),
      session_(std::move(session)),
      queue_(settings.queue_bytes),
      held_back_bytes_(settings.queue_bytes / 8),
      max_held_bytes_(settings.queue_bytes / 4),
      write_timeout_(settings.write_timeout_s),
      wake_(executor_, asio::steady_timer::time_point::max()),
      progress_(executor_),
      work_(executor_, asio::steady_timer::time_point::max()),
      capacity_(executor_, asio::steady_timer::time_point::max()),
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
  asio::co_spawn(
      executor_,
      [](std::shared_ptr<Connection> self) -> asio::awaitable<void> {
        co_await self->serve_held();
      }(shared_from_this()),
      asio::detached);
  try {
    co_await read();
  } catch (const std::exception& e) {
    spdlog::error("connection {} ends: {}", session_.id, e.what());
  }
  read_ended_ = true;
  on_client_close();
  work_.cancel();
  while (!served_) co_await wait(capacity_);
  server_.close(session_);
  while (!finishing_) co_await wait(pending_timer_);
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

void Connection::on_client_close() {
  session_.overtaken = held_.size();
  server_.close(session_);
}

void Connection::on_sent_part() {
  sent_part_ = true;
  progress_.cancel();
}

void Connection::send(std::string line, LineKind kind) {
  if (write_ended_ || (finishing_ && kind == LineKind::kTelemetry)) return;
  const std::uint64_t dropped = queue_.telemetry_dropped();
  const bool fits = queue_.push(std::move(line), kind);
  counters().telemetry_dropped += queue_.telemetry_dropped() - dropped;
  if (fits) {
    wake_.cancel();
    if (kind != LineKind::kAnswer) return;
    progress_.cancel();
    work_.cancel();
    capacity_.cancel();
  } else if (!aborted_) {
    report_not_reading();
    aborted_ = true;
    asio::post(executor_, [self = shared_from_this()] { self->abort(); });
  }
}

void Connection::report_not_reading() {
  spdlog::warn("connection {} ({}) does not read; disconnected", session_.id,
               session_.client.empty() ? session_.transport : session_.client);
  ++counters().rejected["slow"];
}

void Connection::abort() noexcept {
  aborted_ = true;
  close();
  wake_.cancel();
  progress_.cancel();
  work_.cancel();
  capacity_.cancel();
}

asio::awaitable<bool> Connection::take(std::string_view text) {
  if (!aborted_) {
    if (!has_to_wait())
      server_.line(session_, text);
    else if (Server::has_emergency_stop(text))
      overtake(text);
    else
      hold({std::string(text)});
  }
  return next_turn();
}

asio::awaitable<bool> Connection::too_long() {
  if (has_to_wait())
    hold({{}, true});
  else if (!aborted_)
    server_.line_too_long(session_);
  return next_turn();
}

bool Connection::held_back() const noexcept {
  return queue_.answer_bytes() + session_.open_bytes > allowed_answer_bytes() ||
         server_.pending(session_) > kMaxPending;
}

bool Connection::full() const noexcept {
  return !write_ended_ &&
         (held_bytes_ > max_held_bytes_ || server_.pending(session_) > 2 * kMaxPending);
}

void Connection::hold(Held line) {
  // A line of no bytes takes memory too.
  held_bytes_ += line.text.size() + sizeof line;
  held_.push_back(std::move(line));
  session_.held = held_.size();
  work_.cancel();
}

void Connection::overtake(std::string_view text) {
  session_.overtaken = 0;
  server_.line(session_, text);
  session_.overtaken = held_.size();
}

void Connection::serve_next() {
  const Held line = std::move(held_.front());
  held_.pop_front();
  held_bytes_ -= line.text.size() + sizeof line;
  if (line.too_long)
    server_.line_too_long(session_);
  else
    server_.line(session_, line.text);
  session_.held = held_.size();
  if (session_.overtaken > 0) --session_.overtaken;
  capacity_.cancel();
}

void Connection::begin_turn() noexcept { turn_ends_ = std::chrono::steady_clock::now() + kTurn; }

asio::awaitable<void> Connection::yield_turn() {
  if (std::chrono::steady_clock::now() <= turn_ends_) co_return;
  co_await asio::post(executor_, asio::use_awaitable);
  begin_turn();
}

asio::awaitable<bool> Connection::next_turn() {
  co_await yield_turn();
  if (held_back()) work_.cancel();
  while (full() && !aborted_) co_await wait(capacity_);
  co_return !aborted_;
}

asio::awaitable<void> Connection::serve_held() {
  try {
    co_await serve_until_end();
  } catch (const std::exception& e) {
    spdlog::error("connection {} ends: {}", session_.id, e.what());
    abort();
  }
  held_.clear();
  session_.held = session_.overtaken = 0;
  served_ = true;
  capacity_.cancel();
}

asio::awaitable<void> Connection::serve_until_end() {
  while (!aborted_) {
    if (held_back() && !write_ended_) {
      co_await wait_for_reader();
      begin_turn();
    } else if (!held_.empty()) {
      serve_next();
      co_await yield_turn();
    } else if (!read_ended_) {
      co_await wait(work_);
      begin_turn();
    } else {
      co_return;
    }
  }
}

asio::awaitable<void> Connection::wait_for_reader() {
  std::size_t untaken = 0;
  const auto restart = [&] {
    sent_part_ = false;
    untaken = untaken_bytes();
    progress_.expires_after(write_timeout_);
  };
  restart();
  while (!aborted_ && !write_ended_ && held_back()) {
    error_code woken;
    co_await progress_.async_wait(asio::redirect_error(asio::use_awaitable, woken));
    if (woken && !sent_part_) continue;
    // The system sends from a buffer of its own, and tells when there is much space in it again.
    const bool waits = queue_.answer_bytes() > allowed_answer_bytes();
    if (!waits || sent_part_ || untaken_bytes() < untaken) {
      restart();
    } else if (!aborted_) {
      report_not_reading();
      abort();
    }
  }
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
    on_sent_part();
  }
  write_ended_ = true;
  progress_.cancel();
  capacity_.cancel();
  if (!ec && !aborted_) co_await finish_stream();
  close_timer_.cancel();
  close();
}

}  // namespace hedgehog::server
