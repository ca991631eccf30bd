// SPDX-License-Identifier: MIT
// Translation of a broker's messages into requests, and of responses into messages.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <nlohmann/json.hpp>

#include "clients/mqtt/remote_requests.h"

namespace hedgehog::mqtt {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

const Topics kLabTopics("lab/hedgehog", "HH 1/2");

Message message_to(const std::string& topic, const std::string& payload) {
  Message message;
  message.topic = topic;
  message.payload = payload;
  return message;
}

TEST(MqttTopics, AreBelowThePrefixWithTheIdAsOneLevel) {
  EXPECT_EQ(kLabTopics.id(), "HH-1-2");
  EXPECT_EQ(kLabTopics.availability(), "lab/hedgehog/HH-1-2/availability");
  EXPECT_EQ(kLabTopics.event("overrun"), "lab/hedgehog/HH-1-2/event/overrun");
  EXPECT_EQ(Topics("hedgehog", "").id(), "-");
}

RC_GTEST_PROP(MqttTopics, HaveNoWildcardAndNoFurtherLevelForAnyId, (const std::string& id)) {
  const std::string level = topic_level(id);
  RC_ASSERT(level.find_first_of("+#/") == std::string::npos);
  RC_ASSERT(!level.empty());
  RC_ASSERT(topic_level(level) == level);
}

TEST(MqttRequest, IsTheMethodOfItsTopicWithThePayloadAsParameters) {
  const auto request = remote_request(
      kLabTopics, message_to("lab/hedgehog/HH-1-2/effect/pulse", "{\n\"direction\": \"left\"}"));
  ASSERT_TRUE(request.has_value());
  EXPECT_EQ(request->method, "effect.pulse");
  EXPECT_EQ(request->params_json, R"({"direction":"left"})");
}

TEST(MqttRequest, WithoutAPayloadHasNoParameters) {
  const auto request =
      remote_request(kLabTopics, message_to("lab/hedgehog/HH-1-2/effect/stop_all", ""));
  EXPECT_EQ(request->params_json, "{}");
}

TEST(MqttRequest, MayNotDoWhatNeedsTheRoleOperate) {
  for (const auto& [topic, payload] :
       {std::pair("pulse", R"({"direction": [1, 0, 0], "frame": "coil"})"),
        std::pair("pulse", R"({"direction": "left", "priority": 8})"),
        std::pair("update", R"({"slot": "engine", "priority": 7.5})"),
        std::pair("stop_all", R"({"scope": "all"})")}) {
    const auto request = remote_request(
        kLabTopics, message_to(std::string("lab/hedgehog/HH-1-2/effect/") + topic, payload));
    ASSERT_TRUE(request.has_error()) << payload;
    EXPECT_EQ(request.error().code, protocol::ErrorCode::kForbidden);
    EXPECT_EQ(request.error().role_needed, protocol::Role::kOperate);
  }
  EXPECT_TRUE(remote_request(kLabTopics, message_to("lab/hedgehog/HH-1-2/effect/pulse",
                                                    R"({"direction": "left", "priority": 7})")));
}

// A button of Home Assistant sends plain text.
TEST(MqttRequest, OfTheEmergencyStopMayHaveAnyPayload) {
  for (const char* payload : {"", "PRESS", "{", "[1]"}) {
    const auto request =
        remote_request(kLabTopics, message_to("lab/hedgehog/HH-1-2/emergency_stop", payload));
    ASSERT_TRUE(request.has_value()) << payload;
    EXPECT_EQ(request->method, "device.emergency_stop");
  }
}

TEST(MqttRequest, OfAMethodThatBrokerClientsMayNotCallIsRefused) {
  for (const char* topic :
       {"effect/preview", "effect/", "effect/pulse/x", "device/arm", "effect"}) {
    const auto request =
        remote_request(kLabTopics, message_to("lab/hedgehog/HH-1-2/" + std::string(topic), "{}"));
    ASSERT_FALSE(request.has_value()) << topic;
    EXPECT_EQ(request.error().code, protocol::ErrorCode::kMethodNotFound);
  }
  EXPECT_FALSE(
      remote_request(kLabTopics, message_to("lab/hedgehog/other/effect/pulse", "{}")).has_value());
}

TEST(MqttRequest, WithAPayloadThatIsNoObjectIsRefused) {
  for (const char* payload : {"left", "[]", "1", "null", "{\"a\":", "{\"a\":\"\xff\"}"}) {
    const auto request =
        remote_request(kLabTopics, message_to("lab/hedgehog/HH-1-2/effect/pulse", payload));
    ASSERT_FALSE(request.has_value()) << payload;
    EXPECT_EQ(request.error().code, protocol::ErrorCode::kInvalidParams);
    EXPECT_THAT(request.error().message, HasSubstr("effect.pulse"));
  }
}

RC_GTEST_PROP(MqttRequest, OfAnyBytesIsRefusedOrOneLine, (const std::string& payload)) {
  const auto request =
      remote_request(kLabTopics, message_to("lab/hedgehog/HH-1-2/effect/pulse", payload));
  if (!request) return;
  RC_ASSERT(request->params_json.find('\n') == std::string::npos);
  RC_ASSERT(json::parse(request->params_json).is_object());
}

TEST(MqttResponse, GoesToTheResponseTopicWithItsCorrelation) {
  Message request = message_to("lab/hedgehog/HH-1-2/effect/pulse", "{}");
  request.response_topic = "replies/7";
  request.correlation = std::string("\0x", 2);
  PendingRequests pending;
  pending.add(protocol::Id::number(3), request);
  const auto responses =
      pending.take(kLabTopics, {protocol::Id::number(3), std::string(R"({"effect":1})")});
  ASSERT_THAT(responses, SizeIs(1));
  EXPECT_EQ(responses[0].topic, "replies/7");
  EXPECT_EQ(responses[0].correlation, request.correlation);
  EXPECT_EQ(responses[0].payload, R"({"result":{"effect":1}})");
  EXPECT_THAT(pending.take(kLabTopics, {protocol::Id::number(3), std::string("{}")}), IsEmpty());
}

TEST(MqttResponse, WithoutAResponseTopicIsSentForRefusalsOnly) {
  const Message request = message_to("lab/hedgehog/HH-1-2/effect/pulse", "{}");
  EXPECT_THAT(response_to(kLabTopics, request, std::string("{}")), IsEmpty());
  const auto responses =
      response_to(kLabTopics, request, protocol::out_of_range("level", 1.0, 1.4));
  ASSERT_THAT(responses, SizeIs(1));
  EXPECT_EQ(responses[0].topic, kLabTopics.refused());
  const json body = json::parse(responses[0].payload);
  EXPECT_EQ(body["topic"], request.topic);
  EXPECT_EQ(body["error"]["code"], -32602);
  EXPECT_EQ(body["error"]["data"]["field"], "level");
}

TEST(MqttResponse, IsSentForAllWhenTheDaemonDisconnects) {
  PendingRequests pending;
  Message request = message_to("lab/hedgehog/HH-1-2/effect/pulse", "{}");
  request.response_topic = "replies/7";
  for (std::size_t i = 0; i < PendingRequests::kMax; ++i) {
    EXPECT_FALSE(pending.full());
    pending.add(protocol::Id::number(static_cast<std::int64_t>(i)), request);
  }
  EXPECT_TRUE(pending.full());
  const auto responses = pending.take_all(kLabTopics);
  EXPECT_THAT(responses, SizeIs(PendingRequests::kMax));
  EXPECT_EQ(json::parse(responses[0].payload)["error"]["data"]["name"], "device_absent");
  EXPECT_FALSE(pending.full());
}

}  // namespace
}  // namespace hedgehog::mqtt
