// SPDX-License-Identifier: MIT
// Handling of messages that the program has not fetched yet.
#include "clients/mqtt/broker.h"

#include <gtest/gtest.h>

#include "tests/mqtt/mosquitto.h"

namespace hedgehog::e2e {
namespace {

using mqtt::Broker;
using mqtt::BrokerConnected;
using mqtt::Message;

// An emergency stop is neither lost among other requests nor executed after them.
TEST(MqttBroker, SendsUrgentMessagesFirstAlsoWhenTheQueueOverflows) {
  const Home home;
  const Mosquitto mosquitto(home);
  mqtt::BrokerOptions options;
  options.host = mosquitto.socket();
  options.port = 0;
  options.client_id = "urgent-test";
  options.urgent_topic = "urgent";
  const auto broker = Broker::open(options).value();
  ASSERT_TRUE(eventually([&] {
    const auto notice = broker->next();
    return notice && std::holds_alternative<BrokerConnected>(*notice);
  }));
  broker->subscribe("#", mqtt::Delivery::kQos0);
  const auto send = [&](const std::string& topic) {
    publish(home, mosquitto.socket(), topic, "x");
  };
  ASSERT_TRUE(eventually([&] {
    send("listening");
    return broker->next().has_value();
  }));
  while (broker->next()) continue;

  // Nothing is fetched from here on.
  publish(home, mosquitto.socket(), "other", "x",
          {"--repeat", std::to_string(Broker::kMaxArrived + 44)});
  send("urgent");
  std::uint64_t dropped = 0;
  EXPECT_TRUE(eventually([&] {
    send("after");  // one that arrives after `urgent`
    return (dropped += broker->take_dropped()) > 44;
  }));

  const auto first = broker->next();
  ASSERT_TRUE(first.has_value());
  EXPECT_EQ(std::get<Message>(*first).topic, "urgent");
  std::size_t others = 0;
  while (const auto notice = broker->next()) ++others;
  EXPECT_EQ(others, Broker::kMaxArrived);
}

}  // namespace
}  // namespace hedgehog::e2e
