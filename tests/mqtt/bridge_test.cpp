// SPDX-License-Identifier: MIT
// hedgehog-mqtt between a real daemon and Debian's broker, observed by Debian's MQTT clients.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <optional>

#include "tests/e2e/daemon_process.h"
#include "tests/e2e/program.h"
#include "tests/e2e/programs.h"
#include "tests/e2e/raw_client.h"
#include "tests/folders.h"
#include "tests/mqtt/mosquitto.h"

namespace hedgehog::e2e {
namespace {

using testing::HasSubstr;

class MqttBridge : public ::testing::Test {
 protected:
  /// Started, and connected to both.
  void start(const std::vector<std::string>& more = {}) {
    std::vector<std::string> arguments{
        "--address", daemon->socket(), "--broker",      broker.socket(),
        "--id",      "HH-0042",        "--keepalive-s", "5"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    bridge.emplace(home, hedgehog_mqtt(), arguments, more_variables);
    ASSERT_TRUE(subscriber.receives("0 hedgehog/HH-0042/availability online"));
  }
  Json call(const std::string& method, const Json& params = Json::object()) {
    return RawClient(daemon->socket()).call(method, params);
  }
  /// The response is on the topic replies/1.
  Ended request_pulse() {
    Program request(
        home, "/usr/bin/mosquitto_rr",
        {"--unix", broker.socket(), "-V", "5", "-W", "60", "-t", "hedgehog/HH-0042/effect/pulse",
         "-e", "replies/1", "-m", R"({"direction": "left", "level": 0.5, "duration_ms": 200})"});
    return request.wait();
  }

  Home home;
  Mosquitto broker{home};
  Subscriber subscriber{home, broker.socket(), {"#"}};
  std::optional<DaemonProcess> daemon{std::in_place, home};
  std::optional<Program> bridge;
  std::vector<std::string> more_variables;
};

TEST_F(MqttBridge, RetainsMessagesForLateSubscribers) {
  start();
  const Subscriber late(home, broker.socket(), {"#"});
  EXPECT_TRUE(late.receives("1 hedgehog/HH-0042/availability online"));
  EXPECT_TRUE(late.receives("1 hedgehog/HH-0042/status {\"device\":\"ball\""));
  EXPECT_TRUE(late.receives("1 hedgehog/HH-0042/description {\"name\":\"ball\""));
  EXPECT_TRUE(late.receives("1 homeassistant/sensor/hedgehog-HH-0042/temperature/config {"));
  EXPECT_TRUE(late.receives("0 hedgehog/HH-0042/telemetry {\"device\":\"ball\""));
}

TEST_F(MqttBridge, NamesTheBallOfEachMessage) {
  const Subscriber properties(home, broker.socket(), {"hedgehog/#", "replies/#"}, "%t %P");
  start();
  EXPECT_EQ(request_pulse().exit_code, 0);
  for (const char* topic :
       {"hedgehog/HH-0042/availability", "hedgehog/HH-0042/status", "hedgehog/HH-0042/description",
        "hedgehog/HH-0042/telemetry", "hedgehog/HH-0042/event/effect_started", "replies/1"})
    EXPECT_TRUE(properties.receives(topic + std::string(" device:HH-0042 model:hedgehog-86")));
}

TEST_F(MqttBridge, PlaysRequestsAndRespondsOnTheResponseTopic) {
  start();
  const Ended ended = request_pulse();
  EXPECT_EQ(ended.exit_code, 0) << ended.err;
  EXPECT_THAT(ended.out, HasSubstr(R"({"result":{"effect":1,"accepted":true)"));
  EXPECT_TRUE(
      subscriber.receives("0 hedgehog/HH-0042/event/effect_started {\"type\":\"effect_started\""));
  EXPECT_TRUE(
      subscriber.receives("0 hedgehog/HH-0042/event/effect_ended {\"type\":\"effect_ended\""));
}

TEST_F(MqttBridge, ReportsWhyARequestIsRefused) {
  start();
  publish(home, broker.socket(), "hedgehog/HH-0042/effect/pulse", R"({"direction": "lefty"})");
  ASSERT_TRUE(subscriber.receives("0 hedgehog/HH-0042/refused "));
  EXPECT_THAT(subscriber.all(), HasSubstr("there is no 'lefty'; did you mean 'left'?"));
  publish(home, broker.socket(), "hedgehog/HH-0042/effect/preview", "{}");
  EXPECT_TRUE(eventually([&] { return subscriber.count("0 hedgehog/HH-0042/refused ") == 2; }));
}

// It would play each time the bridge reconnects.
TEST_F(MqttBridge, DoesNotPlayARetainedRequest) {
  publish(home, broker.socket(), "hedgehog/HH-0042/effect/pulse", R"({"direction": "left"})",
          {"-r"});
  start();
  publish(home, broker.socket(), "hedgehog/HH-0042/effect/pulse", R"({"direction": "up"})", {"-r"});
  publish(home, broker.socket(), "hedgehog/HH-0042/effect/pulse", R"({"direction": "up"})");
  ASSERT_TRUE(subscriber.receives("0 hedgehog/HH-0042/event/effect_ended "));
  EXPECT_EQ(subscriber.count("0 hedgehog/HH-0042/event/effect_started "), 1);
}

TEST_F(MqttBridge, StopsTheBallForAnyClient) {
  start();
  publish(home, broker.socket(), "hedgehog/HH-0042/emergency_stop", "PRESS", {"-q", "1"});
  ASSERT_TRUE(subscriber.receives("0 hedgehog/HH-0042/event/state_changed "));
  EXPECT_EQ(call("device.status")["state"], "disarmed");
  EXPECT_TRUE(eventually([&] {
    return subscriber.all().find(
               "\"state\":\"disarmed\",\"reason\":\"emergency_stop\",\"since_s\"") !=
           std::string::npos;
  }));
}

TEST_F(MqttBridge, ThatEndsPublishesIt) {
  start();
  bridge->signal(SIGTERM);
  EXPECT_EQ(bridge->wait().exit_code, 130);
  EXPECT_TRUE(subscriber.receives("0 hedgehog/HH-0042/availability offline"));
}

TEST_F(MqttBridge, ThatIsKilledOrHangsIsReportedByTheBroker) {
  start();
  bridge->signal(SIGKILL);
  EXPECT_TRUE(subscriber.receives("0 hedgehog/HH-0042/availability offline"));
  const int offline_count = subscriber.count("0 hedgehog/HH-0042/availability offline");
  bridge.emplace(
      home, hedgehog_mqtt(),
      std::vector<std::string>{"--address", daemon->socket(), "--broker", broker.socket(), "--id",
                               "HH-0042", "--keepalive-s", "5"});
  ASSERT_TRUE(
      eventually([&] { return subscriber.count("0 hedgehog/HH-0042/availability online") == 2; }));
  bridge->signal(SIGSTOP);
  EXPECT_TRUE(eventually(
      [&] { return subscriber.count("0 hedgehog/HH-0042/availability offline") > offline_count; }));
  bridge->signal(SIGCONT);
  EXPECT_TRUE(
      eventually([&] { return subscriber.count("0 hedgehog/HH-0042/availability online") == 3; }));
}

TEST_F(MqttBridge, PublishesMissedEventsToTheNextBroker) {
  start();
  broker.stop();
  call("device.emergency_stop");
  // The bridge must not reconnect before the subscriber is connected.
  bridge->signal(SIGSTOP);
  broker.start();
  const Subscriber second(home, broker.socket(), {"#"});
  bridge->signal(SIGCONT);
  EXPECT_TRUE(second.receives("0 hedgehog/HH-0042/availability online"));
  EXPECT_TRUE(second.receives("0 hedgehog/HH-0042/status "));
  EXPECT_TRUE(second.receives("0 hedgehog/HH-0042/event/state_changed "));
}

// A broker that neither reads nor responds, as on a disconnected network.
TEST_F(MqttBridge, KeepsServingTheDaemonWhileTheBrokerHangs) {
  start({"--telemetry-hz", "200"});
  broker.signal(SIGSTOP);
  call("device.emergency_stop");
  EXPECT_TRUE(eventually([&] { return call("device.status")["state"] == "disarmed"; }));
  const auto own = [&](const Json& one) {
    const std::string client = one.value("client", "");
    return client.starts_with("hedgehog-mqtt/");
  };
  const Json connections = call("connection.list")["connections"];
  EXPECT_TRUE(std::any_of(connections.begin(), connections.end(), own)) << connections;
  broker.signal(SIGCONT);
  EXPECT_TRUE(subscriber.receives("0 hedgehog/HH-0042/event/state_changed "));
}

TEST_F(MqttBridge, ReportsThatTheDaemonIsOfflineAndOnlineAgain) {
  start();
  const std::string address = daemon->socket();
  daemon->stop();
  ASSERT_TRUE(subscriber.receives("0 hedgehog/HH-0042/availability offline"));
  publish(home, broker.socket(), "hedgehog/HH-0042/effect/pulse", R"({"direction": "up"})");
  EXPECT_TRUE(subscriber.receives("0 hedgehog/HH-0042/refused "));
  EXPECT_THAT(subscriber.all(), HasSubstr("no connection to the daemon"));
  daemon.emplace(home);
  ASSERT_EQ(daemon->socket(), address);
  EXPECT_TRUE(
      eventually([&] { return subscriber.count("0 hedgehog/HH-0042/availability online") == 2; }));
}

// Its socket still accepts connections, as the kernel does that.
TEST_F(MqttBridge, ReportsThatAHangingDaemonIsOffline) {
  more_variables = {"HEDGEHOG_PATIENCE_MS=2000"};
  start({"--status-s", "0.5"});
  daemon->signal(SIGSTOP);
  EXPECT_TRUE(subscriber.receives("0 hedgehog/HH-0042/availability offline"));
  daemon->signal(SIGCONT);
  EXPECT_TRUE(
      eventually([&] { return subscriber.count("0 hedgehog/HH-0042/availability online") >= 2; }));
}

/// Lines of the README that begin with `program`, indented as commands, without their comments.
std::vector<std::string> readme_commands(const std::string& program) {
  std::ifstream readme(source_folder() + "/clients/mqtt/README.md");
  std::vector<std::string> found;
  for (std::string line; std::getline(readme, line);)
    if (line.starts_with("    " + program)) found.push_back(line.substr(4, line.find("   #") - 4));
  return found;
}

std::string with(std::string command, const std::string& from, const std::string& to) {
  const auto at = command.find(from);
  return at == std::string::npos ? command : command.replace(at, from.size(), to);
}

TEST_F(MqttBridge, IsUsedByTheCommandsOfItsReadme) {
  const auto bridges = readme_commands("hedgehog-mqtt");
  const auto publish_commands = readme_commands("mosquitto_pub");
  ASSERT_EQ(bridges.size(), 2u);
  ASSERT_EQ(publish_commands.size(), 1u);
  const std::string command = with(with(bridges[0], "hedgehog-mqtt", "exec " + hedgehog_mqtt()),
                                   "broker.lan", broker.socket());
  bridge.emplace(home, "/bin/sh", std::vector<std::string>{"-c", command + " --id HH-0042"},
                 std::vector<std::string>{"HEDGEHOG_ADDRESS=" + daemon->socket()});
  ASSERT_TRUE(subscriber.receives("0 hedgehog/HH-0042/availability online"));
  Program publisher(
      home, "/bin/sh",
      {"-c", with(publish_commands[0], "-h broker.lan", "--unix " + broker.socket())});
  EXPECT_EQ(publisher.wait().exit_code, 0);
  EXPECT_TRUE(subscriber.receives("0 hedgehog/HH-0042/event/effect_started "));
  EXPECT_EQ(subscriber.count("0 hedgehog/HH-0042/refused "), 0);
}

TEST_F(MqttBridge, EndsWithASentenceForUnknownFields) {
  Program wrong(home, hedgehog_mqtt(),
                {"--address", daemon->socket(), "--broker", broker.socket(), "--fields", "warmth"});
  const Ended ended = wrong.wait();
  EXPECT_EQ(ended.exit_code, 64);
  EXPECT_THAT(ended.err, HasSubstr("warmth"));
}

}  // namespace
}  // namespace hedgehog::e2e
