// SPDX-License-Identifier: MIT
// The topics of one ball: PREFIX/ID/... (README.md has the table).
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace hedgehog::mqtt {

/// `text` as one level of a topic, and as a part of a client's name: letters, digits, '.', '_' and
/// '-' are kept, other characters are replaced by '-'. Never empty.
std::string topic_level(std::string_view text);

class Topics {
 public:
  /// `prefix` may have several levels ("lab/hedgehog"); `id` is converted to one level.
  Topics(std::string_view prefix, std::string_view id);

  const std::string& id() const noexcept { return id_; }
  /// Retained: "online" or, also as the last will, "offline".
  std::string availability() const { return base_ + "availability"; }
  /// Retained: the result of device.status.
  std::string status() const { return base_ + "status"; }
  /// Retained: the result of device.describe.
  std::string description() const { return base_ + "description"; }
  std::string telemetry() const { return base_ + "telemetry"; }
  std::string event(std::string_view type) const { return base_ + "event/" + std::string(type); }
  /// Errors of requests without a response topic.
  std::string refused() const { return base_ + "refused"; }
  std::string emergency_stop() const { return base_ + "emergency_stop"; }
  /// ".../effect/+".
  std::string effects() const { return base_ + "effect/+"; }

  /// The method requested by a message on `topic`: "effect.pulse", "device.emergency_stop";
  /// nullopt: unknown, or not allowed for a broker's clients.
  std::optional<std::string> method(std::string_view topic) const;

 private:
  std::string base_;
  std::string id_;
};

/// Methods allowed for a broker's clients: "effect.pulse" ..., and "device.emergency_stop". Sorted.
const std::vector<std::string>& remote_methods();

}  // namespace hedgehog::mqtt
