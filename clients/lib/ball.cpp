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
  if (stage_ == Stage::kAway && client::Clock::now() >= next_attempt_) start_attempt();
  if (stage_ == Stage::kSearching) poll_search({});
  if (stage_ == Stage::kConnecting) poll_connection({});
  for (int lines = 0; lines < kLinesPerFrame && stage_ > Stage::kConnecting; ++lines)
    if (!receive(kNow)) break;
  expire();
}

void Ball::start_attempt() {
  next_address_ = 0;
  tried_.clear();
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
    stay_away(located->error().failure, located->error().message);
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
      due_ = client::Clock::now() + options_.patience;
      return;
    }
    tried_ += (tried_.empty() ? "" : "; ") + to_string(located_[next_address_++]) + ": " +
              started.error().message;
  }
  connection_.reset();
  stay_away(client::Failure::kNoDaemon, "the daemon does not run: " + tried_);
}

void Ball::poll_connection(client::Clock::time_point deadline) {
  const auto connected = connection_->connected(deadline);
  if (connected && *connected) {
    introduce();
    return;
  }
  if (connected && client::Clock::now() < due_) return;
  tried_ += (tried_.empty() ? "" : "; ") + to_string(located_[next_address_++]) + ": " +
            (connected ? "no answer" : connected.error().message);
  start_next_address();
}

void Ball::introduce() {
  stage_ = Stage::kIntroducing;
  notice_.clear();
  const auto& token = options_.token ? options_.token : connection_->address().token;
  auto asked = connection_->ask(protocol::Hello{options_.name, "1.0", token}, kNow);
  if (!asked) {
    lose(asked.error());
    return;
  }
  introduction_ = *asked;
  asked_.push_back({*std::move(asked), client::Clock::now() + options_.patience});
}

bool Ball::receive(client::Milliseconds patience) {
  const auto received = connection_->receive(patience);
  if (!received && received.error().failure == client::Failure::kRefused) {
    notice_ = received.error().message;
    return true;
  }
  if (!received) {
    lose(received.error());
    return false;
  }
  while (auto notification = connection_->notification()) {
    if (notifications_.size() >= kMaxWaiting) notifications_.pop_front();
    notifications_.push_back(*std::move(notification));
  }
  while (connection_) {
    auto reply = connection_->answer();
    if (!reply) break;
    take(*std::move(reply));
  }
  return *received && connection_.has_value();
}

void Ball::take(protocol::Reply reply) {
  std::erase_if(asked_, [&](const Asked& one) { return one.id == reply.id; });
  if (reply.id != introduction_) {
    const auto ended = subscriptions_.answered(reply.id, reply.result.has_value());
    if (ended) keep_refusal(*ended, reply.result.error());
    if (std::erase(renewals_, reply.id) > 0) return;
    if (answers_.size() >= kMaxWaiting) answers_.pop_front();
    answers_.push_back(std::move(reply));
    return;
  }
  introduction_.reset();
  if (!reply.result) {
    lose({client::Failure::kRefused, reply.result.error().message, reply.result.error()});
    return;
  }
  auto hello = protocol::decode_result<protocol::HelloResult>(*reply.result);
  if (!hello) {
    lose({client::Failure::kProtocol, hello.error().message, {}});
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
  if (asked_.empty() || client::Clock::now() < asked_.front().deadline) return;
  lose({client::Failure::kTimeout, "no response within " + seconds(options_.patience), {}});
}

std::optional<protocol::Reply> Ball::answer() {
  if (answers_.empty()) return std::nullopt;
  std::optional<protocol::Reply> oldest = std::move(answers_.front());
  answers_.pop_front();
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
  if (const auto wait = retry_after(); stage_ == Stage::kAway && wait > kNow) {
    return client::ClientError{client::Failure::kNoDaemon,
                               "the daemon does not run; next attempt in " + seconds(wait),
                               {}};
  }
  // `update` may already have started an attempt.
  update();
  while (stage_ == Stage::kSearching) poll_search(client::Clock::now() + client::kSearchTime);
  while (stage_ == Stage::kConnecting) poll_connection(due_);
  while (stage_ == Stage::kIntroducing) {
    receive(left_until(asked_.front().deadline));
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
  const auto asked = send(request);
  if (!asked) return asked.error();
  subscriptions_.asked(*asked, request);
  const auto deadline = asked_.back().deadline;
  while (connected()) {
    receive(left_until(deadline));
    if (auto reply = take_answer(*asked)) {
      if (reply->result) return *std::move(reply->result);
      return client::ClientError{client::Failure::kRefused, reply->result.error().message,
                                 reply->result.error()};
    }
    expire();
  }
  return *failure_;
}

std::optional<protocol::Reply> Ball::take_answer(const protocol::Id& id) {
  const auto found = std::find_if(answers_.begin(), answers_.end(),
                                  [&](const protocol::Reply& one) { return one.id == id; });
  if (found == answers_.end()) return std::nullopt;
  std::optional<protocol::Reply> reply = std::move(*found);
  answers_.erase(found);
  return reply;
}

client::Outcome<std::optional<client::Notification>> Ball::next(client::Milliseconds patience) {
  const auto deadline = client::Clock::now() + patience;
  while (notifications_.empty()) {
    if (auto opened = open(); !opened) return opened.error();
    if (!receive(left_until(deadline))) {
      if (!connected()) return *failure_;
      break;
    }
  }
  return next();
}

bool Ball::keep(const client::Outcome<void>& sent) {
  if (sent) return true;
  // A request that is too long is the caller's error; the connection stays open.
  if (sent.error().failure != client::Failure::kProtocol) lose(sent.error());
  return false;
}

client::ClientError Ball::lose(const client::ClientError& why) {
  const bool introduced = stage_ == Stage::kConnected;
  connection_.reset();
  asked_.clear();
  // The ids of requests start anew with the next connection.
  answers_.clear();
  renewals_.clear();
  subscriptions_.connection_lost();
  introduction_.reset();
  if (why.failure == client::Failure::kRefused && !introduced) {
    auto refused = stay_away(client::Failure::kRefused, why.message);
    failure_->refusal = why.refusal;
    return refused;
  }
  std::string reason = why.message;
  if (why.failure == client::Failure::kProtocol)
    reason = "what answers is no Hedgehog daemon: " + reason;
  if (!notice_.empty()) reason += " (it said: " + notice_ + ")";
  return stay_away(why.failure, "the connection to the daemon has ended: " + reason);
}

client::ClientError Ball::stay_away(client::Failure failure, std::string problem) {
  stage_ = Stage::kAway;
  next_attempt_ = client::Clock::now() + backoff_.next();
  failure_ = client::ClientError{failure, std::move(problem), {}};
  return *failure_;
}

}  // namespace hedgehog
