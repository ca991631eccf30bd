// SPDX-License-Identifier: MIT
#include "clients/racer/feel/ball_link.h"

#include <utility>
#include <variant>

namespace hedgehog::racer {

namespace {

using client::Connection;
using client::Milliseconds;
using client::Outcome;
using protocol::StatusKey;

// Frames must not block.
constexpr Milliseconds kNow{0};
constexpr Milliseconds kConnectTimeout{1000};
constexpr double kTelemetryHz = 60.0;
// Where decoding is slower than telemetry arrives, reading would not end. The rest is read in the
// next frame.
constexpr int kMessagesPerFrame = 100;

}  // namespace

/// Sends a hello and subscribes to telemetry, which contains state and temperatures, so that no
/// events are needed. Blocking, so not for the game's thread.
Outcome<BallLink::Established> BallLink::arrive(const std::vector<client::Address>& addresses) {
  auto daemon = Connection::reopen(addresses, kConnectTimeout);
  if (!daemon) return daemon.error();
  const auto hello = daemon->hello("hedgehog-racer/" HEDGEHOG_VERSION);
  if (!hello) return hello.error();
  protocol::StatusKeys keys;
  for (const auto key :
       {StatusKey::kSimulated, StatusKey::kState, StatusKey::kRemedy, StatusKey::kTemperatureC,
        StatusKey::kLimitA, StatusKey::kBurstS, StatusKey::kDerating, StatusKey::kOrientation})
    keys.add(key);
  const auto subscribed = daemon->call(protocol::TelemetrySubscribe{kTelemetryHz, keys});
  if (!subscribed) return subscribed.error();
  return Established{std::move(*daemon), *hello};
}

BallLink::BallLink(std::vector<client::Address> addresses) : addresses_(std::move(addresses)) {
  poll_connect();
}

BallLink::~BallLink() = default;

/// In the background, because it may take seconds; the race continues. True once connected.
bool BallLink::poll_connect() {
  if (connecting_.valid()) {
    if (connecting_.wait_for(kNow) != std::future_status::ready) return false;
    if (auto arrived = connecting_.get()) {
      daemon_ = std::move(arrived->daemon);
      hello_ = std::move(arrived->hello);
      received_at_ = Clock::now();
      return true;
    } else {
      on_connection_lost(arrived.error());
    }
  }
  if (Clock::now() >= next_attempt_)
    connecting_ = std::async(std::launch::async, arrive, addresses_);
  return false;
}

void BallLink::on_connection_lost(const client::ClientError& why) {
  daemon_.reset();
  problem_ = why.message;
  timed_out_ = why.failure == client::Failure::kTimeout;
  next_attempt_ = Clock::now() + backoff_.next();
}

BallLink::Received BallLink::listen() {
  Received received;
  if (!daemon_) received.arrived = poll_connect();
  for (int messages = 0; daemon_ && messages < kMessagesPerFrame; ++messages) {
    auto notification = daemon_->next(kNow);
    while (auto response = daemon_->response()) received.responses.push_back(*std::move(response));
    if (!notification) {
      on_connection_lost(notification.error());
    } else if (!*notification) {
      break;
    } else if (auto* telemetry = std::get_if<protocol::TelemetryMessage>(&**notification)) {
      received.statuses.push_back(std::move(telemetry->telemetry.status));
      received_at_ = Clock::now();
      backoff_.reset();
    }
  }
  return received;
}

std::optional<protocol::Id> BallLink::request(const protocol::Request& request) {
  // Requests queued at a silent daemon would all be felt at once when it resumes.
  if (!is_receiving()) return std::nullopt;
  auto sent = daemon_->request(request, kNow);
  if (sent) return *std::move(sent);
  on_connection_lost(sent.error());
  return std::nullopt;
}

void BallLink::notify(const protocol::Request& request) {
  if (!daemon_) return;
  if (const auto sent = daemon_->notify(request, kNow); !sent) on_connection_lost(sent.error());
}

bool BallLink::is_receiving() const { return daemon_ && Clock::now() - received_at_ < kSilent; }

bool BallLink::is_late() const { return daemon_ ? !is_receiving() : timed_out_; }

std::string BallLink::problem() const {
  return daemon_ ? "no telemetry from the daemon" : problem_;
}

}  // namespace hedgehog::racer
