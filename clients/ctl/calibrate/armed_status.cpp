// SPDX-License-Identifier: MIT
#include "clients/ctl/calibrate/armed_status.h"

#include <variant>

#include "clients/common/interrupts.h"

namespace hedgehog::client {
namespace {

constexpr Milliseconds kTelemetryPoll{50};
/// Polls without telemetry before an error; Ctrl-C is checked at each poll.
constexpr int kMaxPolls = 60;

}  // namespace

ClientError measuring_failed(const std::string& message) { return {Failure::kClosed, message, {}}; }

ClientError not_armed(const protocol::Status& status) {
  return measuring_failed("the ball is " + status.state + ": " + status.reason.value_or("") + ". " +
                          status.remedy.value_or(""));
}

Outcome<void> subscribe(Session& session, double rate_hz,
                        std::initializer_list<protocol::StatusKey> keys) {
  using protocol::StatusKey;
  protocol::StatusKeys all;
  for (const StatusKey key : {StatusKey::kState, StatusKey::kReason, StatusKey::kRemedy})
    all.add(key);
  for (const StatusKey key : keys) all.add(key);
  if (auto done = session.connection.call(protocol::TelemetrySubscribe{rate_hz, all}); !done)
    return done.error();
  return {};
}

Outcome<protocol::Status> next_status(Session& session) {
  for (int i = 0; i < kMaxPolls; ++i) {
    if (interrupted()) return measuring_failed("interrupted");
    auto notification = session.connection.next(kTelemetryPoll);
    if (!notification) return notification.error();
    if (!*notification) continue;
    if (const auto* telemetry = std::get_if<protocol::TelemetryMessage>(&**notification))
      return telemetry->telemetry.status;
  }
  return measuring_failed("the daemon sends no telemetry any more");
}

}  // namespace hedgehog::client
