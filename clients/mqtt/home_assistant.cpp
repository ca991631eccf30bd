// SPDX-License-Identifier: MIT
#include "clients/mqtt/home_assistant.h"

#include <array>
#include <nlohmann/json.hpp>

namespace hedgehog::mqtt {

namespace {

using Json = nlohmann::ordered_json;

/// One entity. `value`: a Home Assistant template for the status; empty: a button.
struct Entity {
  const char* component;
  const char* object;
  const char* name;
  const char* value;
  const char* unit;
  const char* device_class;
};

constexpr std::array<Entity, 7> kEntities{{
    {"sensor", "temperature", "Hottest winding", "{{ value_json.temperature_c.upper }}", "°C",
     "temperature"},
    {"sensor", "skin", "Shell", "{{ value_json.temperature_c.skin }}", "°C", "temperature"},
    {"sensor", "state", "State", "{{ value_json.state }}", "", ""},
    {"sensor", "limit", "Allowed current", "{{ value_json.limit_a }}", "A", "current"},
    {"sensor", "fan", "Fan", "{{ value_json.fan.speed_rpm }}", "rpm", ""},
    {"binary_sensor", "tripped", "Tripped",
     "{{ 'ON' if value_json.state == 'tripped' else 'OFF' }}", "", "problem"},
    {"button", "emergency_stop", "Emergency stop", "", "", ""},
}};

Message configuration(std::string_view prefix, const Topics& topics, const Entity& entity) {
  Message message;
  message.topic = std::string(prefix) + "/" + entity.component + "/hedgehog-" + topics.id() + "/" +
                  entity.object + "/config";
  message.delivery = Delivery::kQos1;
  message.retained = true;
  return message;
}

}  // namespace

std::vector<Message> discovery(std::string_view prefix, const Topics& topics,
                               const BallIdentity& ball) {
  std::vector<Message> messages;
  for (const Entity& entity : kEntities) {
    Message message = configuration(prefix, topics, entity);
    Json config{{"name", entity.name},
                {"unique_id", "hedgehog-" + topics.id() + "-" + entity.object},
                {"availability_topic", topics.availability()}};
    if (*entity.value == '\0') {
      config["command_topic"] = topics.emergency_stop();
    } else {
      config["state_topic"] = topics.status();
      config["value_template"] = entity.value;
    }
    if (*entity.unit != '\0') config["unit_of_measurement"] = entity.unit;
    if (*entity.device_class != '\0') config["device_class"] = entity.device_class;
    if (*entity.unit != '\0') config["state_class"] = "measurement";
    config["device"] = {{"identifiers", {"hedgehog-" + topics.id()}},
                        {"name", ball.name},
                        {"model", ball.model},
                        {"manufacturer", "Hedgehog"},
                        {"sw_version", ball.version}};
    message.payload = config.dump();
    messages.push_back(std::move(message));
  }
  return messages;
}

}  // namespace hedgehog::mqtt
