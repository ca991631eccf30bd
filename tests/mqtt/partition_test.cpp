// SPDX-License-Identifier: MIT
// hedgehog-mqtt and a broker on another machine, while the network between them is interrupted. The
// other machine is the network namespace `broker` (partition.sh); clients use the broker's Unix
// socket, which is not affected.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <sstream>

#include "tests/e2e/daemon_process.h"
#include "tests/e2e/program.h"
#include "tests/e2e/programs.h"
#include "tests/e2e/raw_client.h"
#include "tests/mqtt/mosquitto.h"

namespace hedgehog::e2e {
namespace {

using testing::HasSubstr;

constexpr const char* kIp = "/bin/ip";
constexpr const char* kBrokerHost = "192.0.2.2";
constexpr const char* kTopics = "0 hedgehog/HH-0042/";
constexpr const char* kPulse = R"({"direction": "left", "duration_ms": 100})";
constexpr const char* kAccepted = R"("accepted":true)";

class MqttPartition : public ::testing::Test {
 protected:
  void SetUp() override {
    ASSERT_TRUE(std::filesystem::exists("/run/netns/broker"))
        << "tests/mqtt/partition.sh runs this test";
    broker.emplace(home, "listener 1883 " + std::string(kBrokerHost) + "\nallow_anonymous true\n",
                   std::vector<std::string>{kIp, "netns", "exec", "broker"});
    subscriber.emplace(home, broker->socket(), std::vector<std::string>{"#"});
    daemon.emplace(home);
  }
  void TearDown() override { set_cable("up"); }

  void start(const std::string& keepalive_s) {
    bridge.emplace(home, hedgehog_mqtt(),
                   std::vector<std::string>{"--address", daemon->socket(), "--broker", kBrokerHost,
                                            "--id", "HH-0042", "--keepalive-s", keepalive_s});
    ASSERT_TRUE(receives(1, "availability online"));
  }
  /// "up" or "down"; at the broker's end, so that the bridge's machine keeps address and route.
  void set_cable(const std::string& state) {
    Program ip(home, kIp, {"-n", "broker", "link", "set", "cable", state});
    const Ended ended = ip.wait();
    ASSERT_EQ(ended.exit_code, 0) << ended.err;
  }

  int count(const std::string& message) const { return subscriber->count(kTopics + message); }
  /// Waits for the `number`th message that begins so; its topic without the ball's prefix.
  bool receives(int number, const std::string& message) const {
    return eventually([&] { return count(message) >= number; });
  }
  /// mosquitto_rr with a request for an effect; its output is the response.
  std::vector<std::string> request_arguments(const std::string& effect,
                                             const std::string& params) const {
    return {"--unix", broker->socket(),
            "-V",     "5",
            "-W",     "60",
            "-t",     "hedgehog/HH-0042/effect/" + effect,
            "-e",     "replies/" + effect,
            "-m",     params};
  }
  std::string request(const std::string& effect, const std::string& params) const {
    Program client(home, "/usr/bin/mosquitto_rr", request_arguments(effect, params));
    const Ended ended = client.wait();
    EXPECT_EQ(ended.exit_code, 0) << ended.err;
    return ended.out;
  }
  /// Plays a pulse by the daemon's own socket, to its end.
  void play_without_bridge() {
    RawClient client(daemon->socket());
    client.call("events.subscribe");
    const Json admitted = client.call("effect.pulse", {{"direction", "left"}});
    EXPECT_TRUE(admitted.value("accepted", false)) << admitted;
    EXPECT_EQ(client.notification("event", "effect_ended")["reason"], "completed");
  }
  /// One of the daemon's connections is the bridge's.
  bool bridge_is_connected() {
    const Json all = RawClient(daemon->socket()).call("connection.list")["connections"];
    return std::any_of(all.begin(), all.end(), [](const Json& one) {
      return one.value("client", "").starts_with("hedgehog-mqtt/");
    });
  }
  /// Every event and every telemetry message has a time of its own.
  void expect_no_duplicates() const {
    std::vector<std::string> messages;
    std::istringstream lines(subscriber->all());
    for (std::string line; std::getline(lines, line);)
      for (const char* kind : {"event/", "telemetry "})
        if (line.starts_with(std::string(kTopics) + kind)) messages.push_back(line);
    std::sort(messages.begin(), messages.end());
    const auto duplicate = std::adjacent_find(messages.begin(), messages.end());
    EXPECT_TRUE(duplicate == messages.end()) << *duplicate;
  }

  Home home;
  std::optional<Mosquitto> broker;
  std::optional<Subscriber> subscriber;
  std::optional<DaemonProcess> daemon;
  std::optional<Program> bridge;
};

TEST_F(MqttPartition, LongerThanTheKeepaliveSendsTheWillAndThenEverythingOnce) {
  start("5");
  EXPECT_THAT(request("pulse", kPulse), HasSubstr(kAccepted));
  ASSERT_TRUE(receives(1, "event/effect_ended "));
  // A request reaches the bridge after the acknowledgements of the events before it: when it is
  // answered, no event is left that would be sent again.
  EXPECT_THAT(request("stop_all", "{}"), HasSubstr("result"));

  set_cable("down");
  publish(home, broker->socket(), "hedgehog/HH-0042/effect/pulse", kPulse);
  play_without_bridge();
  EXPECT_TRUE(receives(1, "availability offline"));
  EXPECT_THAT(broker->log(), HasSubstr("Client hedgehog-HH-0042 has exceeded timeout"));
  EXPECT_TRUE(bridge_is_connected());
  // Both ends have closed the old connection: nothing that was on its way arrives late.
  ASSERT_TRUE(eventually([&] {
    return bridge->err().find("no broker at " + std::string(kBrokerHost)) != std::string::npos;
  })) << bridge->err();
  EXPECT_EQ(count("event/effect_started "), 1);
  const int statuses = count("status ");
  const int telemetry = count("telemetry ");

  set_cable("up");
  ASSERT_TRUE(receives(2, "availability online")) << bridge->err();
  EXPECT_TRUE(receives(statuses + 1, "status "));
  EXPECT_TRUE(receives(telemetry + 2, "telemetry "));
  EXPECT_TRUE(receives(2, "event/effect_ended ")) << "of what was played meanwhile";
  EXPECT_THAT(request("pulse", kPulse), HasSubstr(kAccepted));
  EXPECT_TRUE(receives(3, "event/effect_ended "));

  EXPECT_EQ(count("event/effect_started "), 3) << "the request during the partition is not kept";
  EXPECT_EQ(count("event/effect_ended "), 3);
  EXPECT_EQ(count("availability offline"), 1);
  EXPECT_EQ(count("availability online"), 2);
  EXPECT_EQ(subscriber->count("0 replies/pulse "), 2);
  EXPECT_EQ(count("refused "), 0);
  expect_no_duplicates();
  const Subscriber late(home, broker->socket(), {"#"});
  EXPECT_TRUE(late.receives("1 hedgehog/HH-0042/availability online"));
}

TEST_F(MqttPartition, ShorterThanTheKeepaliveLosesNothing) {
  start("600");
  set_cable("down");
  Program client(home, "/usr/bin/mosquitto_rr", request_arguments("pulse", kPulse));
  play_without_bridge();
  EXPECT_EQ(count("event/effect_started "), 0);

  set_cable("up");
  const Ended ended = client.wait();
  EXPECT_EQ(ended.exit_code, 0) << ended.err;
  EXPECT_THAT(ended.out, HasSubstr(kAccepted));
  EXPECT_TRUE(receives(2, "event/effect_ended "));
  EXPECT_EQ(count("event/effect_started "), 2);
  EXPECT_EQ(count("event/effect_ended "), 2);
  EXPECT_EQ(count("availability online"), 1);
  EXPECT_EQ(count("availability offline"), 0);
  expect_no_duplicates();
}

}  // namespace
}  // namespace hedgehog::e2e
