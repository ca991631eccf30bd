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
    const auto session = context_.sessions.find(due_.front());
    due_.pop_front();
    if (session == context_.sessions.end()) continue;
    std::optional<TelemetrySubscription>& wanted = session->second->telemetry;
    // It has unsubscribed, or subscribed again.
    if (!wanted || !wanted->due) continue;
    wanted->due = false;
    wanted->next += wanted->period;
    if (wanted->next <= now) wanted->next = now + wanted->period;
    next_ = std::min(next_, wanted->next);
    session->second->sink->send_telemetry(line(wanted->fields));
    ++sent;
  }
}

void TelemetryPublisher::find_due(model::Tick now) {
  next_ = kNever;
  for (const auto& [id, session] : context_.sessions) {
    if (!session->telemetry || session->telemetry->due) continue;
    if (session->telemetry->next > now) {
      next_ = std::min(next_, session->telemetry->next);
      continue;
    }
    session->telemetry->due = true;
    due_.push_back(id);
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
