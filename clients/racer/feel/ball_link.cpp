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
Outcome<BallLink::Arrival> BallLink::arrive(const std::vector<client::Address>& addresses) {
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
  return Arrival{std::move(*daemon), *hello};
}

BallLink::BallLink(std::vector<client::Address> addresses) : addresses_(std::move(addresses)) {
  look_for_the_daemon();
}

BallLink::~BallLink() = default;

/// In the background, because it may take seconds; the race continues. True once connected.
bool BallLink::look_for_the_daemon() {
  if (arriving_.valid()) {
    if (arriving_.wait_for(kNow) != std::future_status::ready) return false;
    if (auto arrived = arriving_.get()) {
      daemon_ = std::move(arrived->daemon);
      hello_ = std::move(arrived->hello);
      received_at_ = Clock::now();
      return true;
    } else {
      lose_the_daemon(arrived.error());
    }
  }
  if (Clock::now() >= next_try_) arriving_ = std::async(std::launch::async, arrive, addresses_);
  return false;
}

void BallLink::lose_the_daemon(const client::ClientError& why) {
  daemon_.reset();
  trouble_ = why.message;
  timed_out_ = why.failure == client::Failure::kTimeout;
  next_try_ = Clock::now() + backoff_.next();
}

BallLink::Received BallLink::listen() {
  Received received;
  if (!daemon_) received.arrived = look_for_the_daemon();
  for (int messages = 0; daemon_ && messages < kMessagesPerFrame; ++messages) {
    auto notification = daemon_->next(kNow);
    while (auto answer = daemon_->answer()) received.answers.push_back(*std::move(answer));
    if (!notification) {
      lose_the_daemon(notification.error());
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

std::optional<protocol::Id> BallLink::ask(const protocol::Request& request) {
  // Requests queued at a silent daemon would all be felt at once when it resumes.
  if (!hears()) return std::nullopt;
  auto asked = daemon_->ask(request, kNow);
  if (asked) return *std::move(asked);
  lose_the_daemon(asked.error());
  return std::nullopt;
}

void BallLink::notify(const protocol::Request& request) {
  if (!daemon_) return;
  if (const auto sent = daemon_->notify(request, kNow); !sent) lose_the_daemon(sent.error());
}

bool BallLink::hears() const { return daemon_ && Clock::now() - received_at_ < kSilent; }

bool BallLink::is_late() const { return daemon_ ? !hears() : timed_out_; }

std::string BallLink::trouble() const { return daemon_ ? "the daemon is silent" : trouble_; }

}  // namespace hedgehog::racer
