// SPDX-License-Identifier: MIT
// The ball as a device of Home Assistant.
#include "clients/mqtt/home_assistant.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>

#include "protocol/server_codec.h"
#include "protocol/values/status.h"

namespace hedgehog::mqtt {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::StartsWith;

const Topics kHomeTopics("hedgehog", "HH-0042");
const BallIdentity kBall{"left ball", "hedgehog-86", "0.1.0"};

TEST(HomeAssistant, FindsAnEntityForEachRetainedMessageOfOneDevice) {
  std::set<std::string> ids;
  for (const Message& message : discovery("homeassistant", kHomeTopics, kBall)) {
    EXPECT_TRUE(message.retained);
    EXPECT_THAT(message.topic, StartsWith("homeassistant/"));
    EXPECT_THAT(message.topic, HasSubstr("/hedgehog-HH-0042/"));
    const json config = json::parse(message.payload);
    EXPECT_TRUE(ids.insert(config["unique_id"]).second) << config["unique_id"];
    EXPECT_EQ(config["availability_topic"], kHomeTopics.availability());
    EXPECT_EQ(config["device"]["identifiers"], json::array({"hedgehog-HH-0042"}));
    EXPECT_EQ(config["device"]["name"], "left ball");
    EXPECT_EQ(config["device"]["sw_version"], "0.1.0");
  }
  EXPECT_GE(ids.size(), 5U);
}

// Checks the names in paths like value_json.temperature_c.upper.
TEST(HomeAssistant, ShowsFieldsThatTheStatusHas) {
  protocol::Status ball;
  ball.temperature_c.upper = 30.0;
  ball.temperature_c.skin = 26.0;
  const json status = json::parse(protocol::encode_value(ball));
  for (const Message& message : discovery("homeassistant", kHomeTopics, kBall)) {
    const json config = json::parse(message.payload);
    if (!config.contains("value_template")) continue;
    EXPECT_EQ(config["state_topic"], kHomeTopics.status());
    const std::string value = config["value_template"];
    const auto begin = value.find("value_json.") + 11;
    const auto end = value.find_first_not_of("abcdefghijklmnopqrstuvwxyz_.", begin);
    std::string path = "/" + value.substr(begin, end - begin);
    for (char& c : path)
      if (c == '.') c = '/';
    EXPECT_TRUE(status.contains(json::json_pointer(path))) << path;
  }
}

TEST(HomeAssistant, StopsTheBallByItsButton) {
  bool found = false;
  for (const Message& message : discovery("homeassistant", kHomeTopics, kBall)) {
    const json config = json::parse(message.payload);
    if (!config.contains("command_topic")) continue;
    found = true;
    EXPECT_EQ(config["command_topic"], kHomeTopics.emergency_stop());
  }
  EXPECT_TRUE(found);
}

}  // namespace
}  // namespace hedgehog::mqtt
