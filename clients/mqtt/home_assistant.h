// SPDX-License-Identifier: MIT
// The ball as a device of Home Assistant, by its MQTT discovery: retained messages of
// configuration, read when Home Assistant starts.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "clients/mqtt/message.h"
#include "clients/mqtt/topics.h"

namespace hedgehog::mqtt {

/// What Home Assistant shows of the device.
struct BallIdentity {
  std::string name{};
  std::string model{};
  std::string version{};  // of the daemon
};

/// Messages for `prefix` ("homeassistant"): temperature, state, current limit, fan, a problem when
/// the ball has tripped, and a button for the emergency stop. With the status topic of `topics`.
std::vector<Message> discovery(std::string_view prefix, const Topics& topics,
                               const BallIdentity& ball);

}  // namespace hedgehog::mqtt
