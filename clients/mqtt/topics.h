// SPDX-License-Identifier: MIT
// The topics of one ball: PREFIX/ID/... (README.md has the table).
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace hedgehog::mqtt {

/// `text` as one level of a topic, and as a part of a client's name: letters, digits, '.', '_' and
/// '-' stay, anything else becomes '-'. Never empty.
std::string topic_level(std::string_view text);

class Topics {
 public:
  /// `prefix` may have levels of its own ("lab/hedgehog"); `id` is made one level.
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
  /// Why a request without a response topic was refused.
  std::string refused() const { return base_ + "refused"; }
  std::string emergency_stop() const { return base_ + "emergency_stop"; }
  /// ".../effect/+".
  std::string effects() const { return base_ + "effect/+"; }

  /// The method that a message on `topic` asks for: "effect.pulse", "device.emergency_stop";
  /// nullopt: there is none, or it is none for a broker's clients.
  std::optional<std::string> method(std::string_view topic) const;

 private:
  std::string base_;
  std::string id_;
};

/// What may be asked for: "effect.pulse" ..., and "device.emergency_stop". Sorted.
const std::vector<std::string>& remote_methods();

}  // namespace hedgehog::mqtt
