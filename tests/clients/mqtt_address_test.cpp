// SPDX-License-Identifier: MIT
// Parsing of a broker's address.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "clients/mqtt/broker_address.h"
#include "tests/temporary_folder.h"

namespace hedgehog::mqtt {
namespace {

using testing::HasSubstr;

std::string read(std::string_view text) {
  BrokerOptions options;
  const auto set = set_address(options, text);
  if (!set) return set.error().message;
  return (options.tls ? "tls " : "") + options.host + " " + std::to_string(options.port);
}

TEST(BrokerAddress, IsReadInEveryCommonNotation) {
  EXPECT_EQ(read("broker"), "broker 1883");
  EXPECT_EQ(read("broker:1884"), "broker 1884");
  EXPECT_EQ(read("mqtt://10.0.0.2"), "10.0.0.2 1883");
  EXPECT_EQ(read("mqtts://broker"), "tls broker 8883");
  EXPECT_EQ(read("mqtts://broker:8884"), "tls broker 8884");
  EXPECT_EQ(read("::1"), "::1 1883");
  EXPECT_EQ(read("[::1]"), "::1 1883");
  EXPECT_EQ(read("[::1]:1885"), "::1 1885");
  EXPECT_EQ(read("/run/mosquitto.sock"), "/run/mosquitto.sock 0");
}

TEST(BrokerAddress, AnInvalidOneIsNamed) {
  for (const char* text : {"", "mqtts://", "broker:", "broker:0", "broker:65536"})
    EXPECT_THAT(read(text), HasSubstr("'" + std::string(text) + "' is no broker")) << text;
}

TEST(BrokerPassword, IsTheFirstLineOfItsFile) {
  const TemporaryFolder folder;
  folder.write("password", "secret\r\nsecond line\n");
  EXPECT_EQ(password_of(folder.path("password")).value(), "secret");
  folder.write("empty", "\n");
  EXPECT_EQ(password_of(folder.path("empty")).error().exit_code, EX_NOINPUT);
  EXPECT_THAT(password_of(folder.path("missing")).error().message, HasSubstr("missing"));
}

}  // namespace
}  // namespace hedgehog::mqtt
