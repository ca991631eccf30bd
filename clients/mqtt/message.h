// SPDX-License-Identifier: MIT
// One message of MQTT 5, in either direction.
#pragma once

#include <cstdint>
#include <string>

namespace hedgehog::mqtt {

enum class Delivery : std::uint8_t {
  kQos0,  // at most once: lost with the connection
  kQos1,  // at least once: kept until acknowledged by the broker
};

struct Message {
  std::string topic{};
  std::string payload{};  // JSON, or a word
  Delivery delivery = Delivery::kQos0;
  bool retained = false;
  /// Of a request: the topic for the response; empty: none. Of a response: that of its request.
  std::string response_topic{};
  std::string correlation{};
};

}  // namespace hedgehog::mqtt
