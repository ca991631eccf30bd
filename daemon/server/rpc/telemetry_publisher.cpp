// SPDX-License-Identifier: MIT
#include "daemon/server/rpc/telemetry_publisher.h"

#include <algorithm>
#include <memory>
#include <string>

#include "protocol/server_codec.h"

namespace hedgehog::server {

void TelemetryPublisher::pump() {
  const model::Tick now = context_.device_view.now().tick;
  if (now != tick_) {
    tick_ = now;
    status_ = {};
    lines_.clear();
    find_due(now);
  }
  for (std::size_t sent = 0; sent < kSlice && !due_.empty();) {
    const Due due = due_.front();
    due_.pop_front();
    const auto session = context_.sessions.find(due.id);
    if (session == context_.sessions.end()) continue;
    std::optional<TelemetrySubscription>& wanted = session->second->telemetry;
    if (!wanted || wanted->next != due.tick) continue;
    wanted->next += wanted->period;
    if (wanted->next <= now) wanted->next = now + wanted->period;
    expect(*session->second);
    session->second->sink->send_telemetry(line(wanted->fields));
    ++sent;
  }
}

void TelemetryPublisher::expect(Session& session) {
  session.telemetry->expected = true;
  expected_[session.telemetry->next].push_back(session.id);
}

model::Tick TelemetryPublisher::due_in() const noexcept {
  if (expected_.empty()) return kNever;
  return std::max<model::Tick>(expected_.begin()->first - context_.device_view.now().tick, 1);
}

void TelemetryPublisher::find_due(model::Tick now) {
  while (!expected_.empty() && expected_.begin()->first <= now) {
    const auto& [tick, sessions] = *expected_.begin();
    for (const ConnectionId id : sessions) due_.push_back({id, tick});
    expected_.erase(expected_.begin());
  }
}

const SharedLine& TelemetryPublisher::line(protocol::StatusKeys fields) {
  const auto known = std::find_if(lines_.begin(), lines_.end(),
                                  [&](const auto& entry) { return entry.first == fields; });
  if (known != lines_.end()) return known->second;
  const bool with_pins = fields.contains(protocol::StatusKey::kPins);
  std::string text = protocol::encode_telemetry({fields, status(with_pins)});
  text.push_back('\n');
  return lines_.emplace_back(fields, std::make_shared<const std::string>(std::move(text))).second;
}

const protocol::Status& TelemetryPublisher::status(bool with_pins) {
  std::optional<protocol::Status>& known = status_[with_pins ? 1 : 0];
  if (!known) known = context_.status.status(with_pins);
  return *known;
}

}  // namespace hedgehog::server
