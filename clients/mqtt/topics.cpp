// SPDX-License-Identifier: MIT
#include "clients/mqtt/topics.h"

#include <algorithm>

#include "protocol/methods.h"

namespace hedgehog::mqtt {

namespace {

constexpr bool is_plain(char c) noexcept {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '.' ||
         c == '_' || c == '-';
}

}  // namespace

std::string topic_level(std::string_view text) {
  std::string level(text);
  std::replace_if(
      level.begin(), level.end(), [](char c) { return !is_plain(c); }, '-');
  return level.empty() ? "-" : level;
}

Topics::Topics(std::string_view prefix, std::string_view id) : id_(topic_level(id)) {
  base_ = std::string(prefix) + "/" + id_ + "/";
}

std::optional<std::string> Topics::method(std::string_view topic) const {
  if (topic == emergency_stop()) return std::string(protocol::DeviceEmergencyStop::kMethod.name);
  const std::string effect = base_ + "effect/";
  if (!topic.starts_with(effect)) return std::nullopt;
  std::string method = "effect." + std::string(topic.substr(effect.size()));
  const auto& allowed = remote_methods();
  if (!std::binary_search(allowed.begin(), allowed.end(), method)) return std::nullopt;
  return method;
}

const std::vector<std::string>& remote_methods() {
  static const std::vector<std::string> kAllowed = [] {
    std::vector<std::string> names{std::string(protocol::DeviceEmergencyStop::kMethod.name),
                                   std::string(protocol::EffectUpdate::kMethod.name),
                                   std::string(protocol::EffectStop::kMethod.name),
                                   std::string(protocol::EffectStopAll::kMethod.name)};
    for (const auto& method : protocol::EffectStart::kMethods) names.emplace_back(method.name);
    std::sort(names.begin(), names.end());
    return names;
  }();
  return kAllowed;
}

}  // namespace hedgehog::mqtt
