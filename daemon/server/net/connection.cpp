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

#include "daemon/server/net/wait.h"
#include "daemon/server/session/origin.h"

namespace hedgehog::server {
namespace {

namespace asio = boost::asio;
using boost::system::error_code;

constexpr std::chrono::seconds kCloseTimeout{1};
/// Maximum time for one client before the others are served.
constexpr std::chrono::milliseconds kTurn{1};

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
  // Unauthenticated clients could fill the log.
  spdlog::log(session_.locked ? spdlog::level::debug : spdlog::level::info, "connection {} from {}",
              session_.id, origin_text(session_));
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
  end_turn();
  read_ended_ = true;
  on_client_close();
  serve();
  while (serving_) co_await wait(capacity_);
  served_ = true;
  server_.close(session_);
  while (!finishing_) co_await wait(pending_timer_);
  // At a shutdown the listener finishes connections with pending responses.
  server_.drop_responses(session_);
  spdlog::log(session_.locked ? spdlog::level::debug : spdlog::level::info,
              "connection {} closed{}", session_.id,
              session_.client.empty() ? "" : " (" + session_.client + ")");
}

void Connection::finish() {
  if (finishing_) return;
  finishing_ = true;
  pending_timer_.cancel();
  wake_.cancel();
  if (write_ended_) return;
  close_timer_.expires_after(kCloseTimeout);
  close_timer_.async_wait([self = shared_from_this()](error_code ec) {
    if (!ec) self->abort();
  });
}

void Connection::on_client_close() {
  session_.bypassed = held_.size();
  // Not finished yet: its responses are sent as long as it reads them, which `serve_held` decides.
  session_.held = held_.size() + 1;
  server_.close(session_);
}

void Connection::on_sent_part() {
  sent_part_ = true;
  progress_.cancel();
}

void Connection::send(std::string line, LineKind kind) {
  if (write_ended_ || (finishing_ && kind == LineKind::kTelemetry)) return;
  on_queued(queue_.push(std::move(line), kind), kind);
}

void Connection::send_telemetry(const SharedLine& line) {
  if (write_ended_ || finishing_) return;
  on_queued(queue_.push(line), LineKind::kTelemetry);
}

void Connection::on_queued(bool fits, LineKind kind) {
  counters().telemetry_dropped += queue_.take_dropped();
  if (fits) {
    if (!defer_flush()) flush(Flush::kSoon);
    if (kind != LineKind::kResponse) return;
    progress_.cancel();
    // By bytes only: an answer reduces the number of pending responses.
    if (held_back_by_bytes()) serve();
    capacity_.cancel();
  } else if (!aborted_) {
    report_not_reading();
    aborted_ = true;
    asio::post(executor_, [self = shared_from_this()] { self->abort(); });
  }
}

void Connection::flush(Flush when) {
  if (writing_ || write_ended_ || queue_.bytes() == 0) return;
  if (!send_now(queue_, when)) wake_.cancel();
}

void Connection::sent_now(std::size_t bytes) {
  queue_.sent_part(bytes);
  if (bytes > 0) on_sent_part();
  if (!queue_.unsent().empty()) {
    wake_.cancel();
    return;
  }
  queue_.sent();
  flush(Flush::kSoon);
}

void Connection::report_not_reading() {
  spdlog::warn("connection {} ({}) does not read; disconnected", session_.id,
               session_.client.empty() ? session_.transport : session_.client);
  ++counters().rejected["slow"];
}

void Connection::abort() noexcept {
  aborted_ = true;
  close_socket();
  wake_.cancel();
  progress_.cancel();
  capacity_.cancel();
}

void Connection::take(std::string_view text) {
  if (aborted_) return;
  if (!must_hold())
    execute(text, received_ns_);
  else if (Server::has_emergency_stop(text))
    bypass_held(text);
  else
    hold({std::string(text), false, received_ns_});
}

void Connection::too_long() {
  if (must_hold())
    hold({{}, true});
  else if (!aborted_)
    server_.line_too_long(session_);
}

void Connection::on_received() noexcept {
  const auto now = std::chrono::steady_clock::now();
  begin_turn(now);
  received_ns_ = std::chrono::nanoseconds(now.time_since_epoch()).count();
}

void Connection::begin_turn(std::chrono::steady_clock::time_point now) noexcept {
  turn_ends_ = now + kTurn;
  in_turn_ = true;
}

void Connection::end_turn() {
  in_turn_ = false;
  if (ticket_ && !session_.locked) ticket_.release();
  flush(Flush::kSoon);
}

asio::awaitable<void> Connection::yield_turn() {
  if (std::chrono::steady_clock::now() <= turn_ends_) co_return;
  end_turn();
  co_await asio::post(executor_, asio::use_awaitable);
  begin_turn();
}

bool Connection::must_pause() const noexcept {
  return aborted_ || held_back() || full() || std::chrono::steady_clock::now() > turn_ends_;
}

asio::awaitable<bool> Connection::pause() {
  if (held_back_by_bytes()) flush(Flush::kSoon);
  co_await yield_turn();
  if (held_back()) serve();
  while (full() && !aborted_) {
    end_turn();
    co_await wait(capacity_);
    begin_turn();
  }
  co_return !aborted_;
}

asio::awaitable<void> Connection::write() {
  error_code ec;
  while (!ec && !aborted_) {
    if (queue_.bytes() == 0) {
      if (finishing_) break;
      writing_ = false;
      co_await wait(wake_);
      writing_ = true;
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
  close_socket();
}

void Connection::close_socket() noexcept {
  ticket_.release();
  close();
}

}  // namespace hedgehog::server
