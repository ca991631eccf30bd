// SPDX-License-Identifier: MIT
#include "clients/lib/ball.h"

#include <algorithm>
#include <utility>

namespace hedgehog {
namespace {

// Per frame: where decoding is slower than telemetry arrives, reading would not end.
constexpr int kLinesPerFrame = 100;

std::string seconds(client::Milliseconds time) {
  const auto tenths = std::max<std::int64_t>(1, (time.count() + 50) / 100);
  return std::to_string(tenths / 10) + "." + std::to_string(tenths % 10) + " s";
}

client::Milliseconds left_until(client::Clock::time_point time) {
  return std::max(client::Milliseconds(0),
                  std::chrono::ceil<client::Milliseconds>(time - client::Clock::now()));
}

}  // namespace

Ball::Ball(std::vector<client::Address> addresses, BallOptions options)
    : addresses_(std::move(addresses)), options_(std::move(options)) {}

client::Outcome<Ball> Ball::connect(BallOptions options) {
  auto addresses = client::daemon_addresses();
  if (!addresses) return addresses.error();
  Ball ball(*std::move(addresses), std::move(options));
  if (auto opened = ball.open(); !opened) return opened.error();
  return ball;
}

client::Milliseconds Ball::retry_after() const { return left_until(next_attempt_); }

void Ball::update() {
  if (stage_ == Stage::kDisconnected && client::Clock::now() >= next_attempt_) start_attempt();
  if (stage_ == Stage::kSearching) poll_search({});
  if (stage_ == Stage::kConnecting) poll_connection({});
  for (int lines = 0; lines < kLinesPerFrame && stage_ > Stage::kConnecting; ++lines)
    if (!receive(kNow)) break;
  expire();
}

void Ball::start_attempt() {
  next_address_ = 0;
  attempt_errors_.clear();
  if (client::needs_search(addresses_)) {
    search_.emplace(addresses_);
    stage_ = Stage::kSearching;
    return;
  }
  located_ = addresses_;
  start_next_address();
}

void Ball::poll_search(client::Clock::time_point deadline) {
  auto located = search_->located(deadline);
  if (!located) return;
  search_.reset();
  if (!*located) {
    fail_attempt(located->error().failure, located->error().message);
    return;
  }
  located_ = *std::move(*located);
  start_next_address();
}

void Ball::start_next_address() {
  while (next_address_ < located_.size()) {
    auto started = client::Connection::start(located_[next_address_]);
    if (started) {
      connection_ = *std::move(started);
      stage_ = Stage::kConnecting;
      due_ = client::Clock::now() + options_.timeout;
      return;
    }
    attempt_errors_ += (attempt_errors_.empty() ? "" : "; ") +
                       to_string(located_[next_address_++]) + ": " + started.error().message;
  }
  connection_.reset();
  fail_attempt(client::Failure::kNoDaemon, "the daemon does not run: " + attempt_errors_);
}

void Ball::poll_connection(client::Clock::time_point deadline) {
  const auto connected = connection_->connected(deadline);
  if (connected && *connected) {
    send_hello();
    return;
  }
  if (connected && client::Clock::now() < due_) return;
  attempt_errors_ += (attempt_errors_.empty() ? "" : "; ") + to_string(located_[next_address_++]) +
                     ": " + (connected ? "no answer" : connected.error().message);
  start_next_address();
}

void Ball::send_hello() {
  stage_ = Stage::kHello;
  notice_.reset();
  const auto& token = options_.token ? options_.token : connection_->address().token;
  auto sent = connection_->request(protocol::Hello{options_.name, "1.0", token}, kNow);
  if (!sent) {
    end_connection(sent.error());
    return;
  }
  hello_id_ = *sent;
  pending_.push_back({*std::move(sent), client::Clock::now() + options_.timeout});
}

bool Ball::receive(client::Milliseconds timeout) {
  const auto received = connection_->receive(timeout);
  if (!received && received.error().failure == client::Failure::kRefused) {
    notice_ = received.error();
    return true;
  }
  if (!received) {
    end_connection(received.error());
    return false;
  }
  if (*received) notice_.reset();
  while (auto notification = connection_->notification()) {
    if (notifications_.size() >= kMaxUnread) notifications_.pop_front();
    notifications_.push_back(*std::move(notification));
  }
  while (connection_) {
    auto reply = connection_->response();
    if (!reply) break;
    handle_reply(*std::move(reply));
  }
  return *received && connection_.has_value();
}

void Ball::handle_reply(protocol::Reply reply) {
  std::erase_if(pending_, [&](const PendingRequest& one) { return one.id == reply.id; });
  if (reply.id != hello_id_) {
    const auto ended = subscriptions_.on_response(reply.id, reply.result.has_value());
    if (ended) record_refused_renewal(*ended, reply.result.error());
    if (std::erase(renewals_, reply.id) > 0) return;
    if (responses_.size() >= kMaxUnread) responses_.pop_front();
    responses_.push_back(std::move(reply));
    return;
  }
  hello_id_.reset();
  if (!reply.result) {
    end_connection({client::Failure::kRefused, reply.result.error().message, reply.result.error()});
    return;
  }
  auto hello = protocol::decode_result<protocol::HelloResult>(*reply.result);
  if (!hello) {
    end_connection({client::Failure::kProtocol, hello.error().message, {}});
    return;
  }
  hello_ = *std::move(hello);
  stage_ = Stage::kConnected;
  ++connections_;
  backoff_.reset();
  failure_.reset();
  renew_subscriptions();
}

void Ball::expire() {
  if (pending_.empty() || client::Clock::now() < pending_.front().deadline) return;
  end_connection(
      {client::Failure::kTimeout, "no response within " + seconds(options_.timeout), {}});
}

std::optional<protocol::Reply> Ball::response() {
  if (responses_.empty()) return std::nullopt;
  std::optional<protocol::Reply> oldest = std::move(responses_.front());
  responses_.pop_front();
  return oldest;
}

std::optional<client::Notification> Ball::next() {
  if (notifications_.empty()) return std::nullopt;
  std::optional<client::Notification> oldest = std::move(notifications_.front());
  notifications_.pop_front();
  return oldest;
}

client::Outcome<void> Ball::open() {
  if (connected()) return {};
  if (const auto wait = retry_after(); stage_ == Stage::kDisconnected && wait > kNow) {
    return client::ClientError{client::Failure::kNoDaemon,
                               "the daemon does not run; next attempt in " + seconds(wait),
                               {}};
  }
  // `update` may already have started an attempt.
  update();
  while (stage_ == Stage::kSearching) poll_search(client::Clock::now() + client::kSearchTime);
  while (stage_ == Stage::kConnecting) poll_connection(due_);
  while (stage_ == Stage::kHello) {
    receive(left_until(pending_.front().deadline));
    expire();
  }
  if (connected()) return {};
  return *failure_;
}

client::Outcome<std::string> Ball::call_raw(std::string_view method, std::string_view params_json) {
  return exchange(client::RawRequest{std::string(method), std::string(params_json)});
}

client::Outcome<std::string> Ball::exchange(const client::AnyRequest& request) {
  if (auto opened = open(); !opened) return opened.error();
  const auto sent = send(request);
  if (!sent) return sent.error();
  subscriptions_.on_request(*sent, request);
  const auto deadline = pending_.back().deadline;
  while (connected()) {
    receive(left_until(deadline));
    if (auto reply = take_response(*sent)) {
      if (reply->result) return *std::move(reply->result);
      return client::ClientError{client::Failure::kRefused, reply->result.error().message,
                                 reply->result.error()};
    }
    expire();
  }
  return *failure_;
}

std::optional<protocol::Reply> Ball::take_response(const protocol::Id& id) {
  const auto found = std::find_if(responses_.begin(), responses_.end(),
                                  [&](const protocol::Reply& one) { return one.id == id; });
  if (found == responses_.end()) return std::nullopt;
  std::optional<protocol::Reply> reply = std::move(*found);
  responses_.erase(found);
  return reply;
}

client::Outcome<std::optional<client::Notification>> Ball::next(client::Milliseconds timeout) {
  const auto deadline = client::Clock::now() + timeout;
  while (notifications_.empty()) {
    if (auto opened = open(); !opened) return opened.error();
    if (!receive(left_until(deadline))) {
      if (!connected()) return *failure_;
      break;
    }
  }
  return next();
}

bool Ball::check_sent(const client::Outcome<void>& sent) {
  if (sent) return true;
  // A request that is too long is the caller's error; the connection stays open.
  if (sent.error().failure != client::Failure::kProtocol) end_connection(sent.error());
  return false;
}

client::ClientError Ball::end_connection(const client::ClientError& why) {
  const bool was_connected = stage_ == Stage::kConnected;
  connection_.reset();
  pending_.clear();
  // The ids of requests start anew with the next connection.
  responses_.clear();
  renewals_.clear();
  subscriptions_.on_connection_lost();
  hello_id_.reset();
  if (why.failure == client::Failure::kRefused && !was_connected) {
    auto refused = fail_attempt(client::Failure::kRefused, why.message);
    failure_->refusal = why.refusal;
    return refused;
  }
  std::string reason = why.message;
  if (why.failure == client::Failure::kProtocol)
    reason = "the server is not a Hedgehog daemon: " + reason;
  client::Milliseconds min_wait{0};
  if (notice_) {
    reason += " (message: " + notice_->message + ")";
    min_wait = client::retry_after(*notice_);
  }
  return fail_attempt(why.failure, "the connection to the daemon has ended: " + reason, min_wait);
}

client::ClientError Ball::fail_attempt(client::Failure failure, std::string problem,
                                       client::Milliseconds min_wait) {
  stage_ = Stage::kDisconnected;
  next_attempt_ = client::Clock::now() + std::max(backoff_.next(), min_wait);
  failure_ = client::ClientError{failure, std::move(problem), {}};
  return *failure_;
}

}  // namespace hedgehog
