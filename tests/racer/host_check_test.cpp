// SPDX-License-Identifier: MIT
// Check of host and origin, the address of the listener, and the messages of a page.
#include "clients/racer/server/host_check.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <variant>

#include "clients/racer/drive.h"
#include "clients/racer/server/messages.h"

namespace hedgehog::racer {
namespace {

TEST(HostCheck, AcceptsItsOwnNames) {
  for (const char* own_host : {"127.0.0.1:7585", "localhost:7585", "LocalHost:7585", "[::1]:7585",
                               "127.9.9.9:7585", "127.0.0.1:17585", "localhost"})
    EXPECT_TRUE(is_own_host(own_host)) << own_host;
  for (const char* foreign :
       {"", ":7585", "127.0.0.1:758500", "example.com:7585", "127.0.0.1.example.com:7585",
        "localhost.example:7585", "192.168.1.5:7585", "[::2]:7585", "127.1:7585",
        "localhost:7585:7585", "[localhost]:7585"})
    EXPECT_FALSE(is_own_host(foreign)) << foreign;
  // Only its own page may connect.
  EXPECT_TRUE(may_connect("localhost:7585", std::nullopt));
  EXPECT_TRUE(may_connect("localhost:7585", "http://localhost:7585"));
  for (const char* origin : {"http://localhost:7586", "http://127.0.0.1:7585", "null", "",
                             "https://localhost:7585", "http://evil.example"})
    EXPECT_FALSE(may_connect("localhost:7585", origin)) << origin;
}

TEST(ListenAt, AcceptsAnAddressWithAPort) {
  EXPECT_EQ(listen_at("127.0.0.1:0").value().port, 0);
  EXPECT_EQ(listen_at("[::1]:7585").value().address, "::1");
  for (const char* text : {"", "7585", ":7585", "127.0.0.1", "127.0.0.1:", "127.0.0.1:70000",
                           "127.0.0.1:7585x", "127.0.0.1:-1"})
    EXPECT_FALSE(listen_at(text)) << text;
}

TEST(PageMessages, AreAcceptedOrRefusedWithASentence) {
  const auto keys =
      std::get<KeysHeld>(page_message(R"({"type":"keys","steer":-0.5,"throttle":1,"brake":0})"));
  EXPECT_EQ(keys.controls, (Controls{-0.5, 1.0, 0.0}));
  EXPECT_EQ(std::get<ModeRequest>(page_message(R"({"type":"mode","mode":"ball"})")).mode,
            Mode::kBall);
  EXPECT_FALSE(std::get<PauseRequest>(page_message(R"({"type":"pause","on":false})")).on);
  EXPECT_TRUE(std::holds_alternative<ResetRequest>(page_message(R"({"type":"reset"})")));
  for (const char* text :
       {"", "{", "[]", "7", "null", "{}", R"({"type":7})", R"({"type":"fly"})",
        R"({"type":"keys","steer":1.5})", R"({"type":"keys","steer":"left"})",
        R"({"type":"keys","throttle":-0.1})", R"({"type":"keys","brake":1e999})",
        R"({"type":"pause"})", R"({"type":"pause","on":1})", R"({"type":"mode"})",
        R"({"type":"mode","mode":"autopilot"})", "{\"type\":\"\xff\"}", "\xff\xfe"}) {
    const PageMessage message = page_message(text);
    ASSERT_TRUE(std::holds_alternative<InvalidMessage>(message)) << text;
    EXPECT_FALSE(std::get<InvalidMessage>(message).why.empty());
  }
  EXPECT_TRUE(std::holds_alternative<InvalidMessage>(
      page_message(R"({"type":"reset"})" + std::string(1, '\0') + "garbage")))
      << "a NUL ends no text";
}

}  // namespace
}  // namespace hedgehog::racer
