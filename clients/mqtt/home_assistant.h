// SPDX-License-Identifier: MIT
// The ball as a device of Home Assistant, by its MQTT discovery: retained configuration messages,
// read by Home Assistant at its start.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "clients/mqtt/message.h"
#include "clients/mqtt/topics.h"

namespace hedgehog::mqtt {

/// Data of the device in Home Assistant.
struct BallIdentity {
  std::string name{};
  std::string model{};
  std::string version{};  // of the daemon
};

/// Messages for `prefix` ("homeassistant"): temperature, state, current limit, fan, a problem if
/// the ball has tripped, and a button for the emergency stop. They refer to the status topic of
/// `topics`.
std::vector<Message> discovery(std::string_view prefix, const Topics& topics,
                               const BallIdentity& ball);

}  // namespace hedgehog::mqtt
