// SPDX-License-Identifier: MIT
// Search for balls on the network: the vectors of tests/sdk/mdns.json, and searches on the loopback
// interface.
#include "clients/lib/discovery/ball_search.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>

#include "clients/lib/ball.h"
#include "clients/lib/discovery/choice.h"
#include "clients/lib/discovery/mdns_answers.h"
#include "tests/folders.h"
#include "tests/mdns_responder.h"

namespace hedgehog::client {
namespace {

using nlohmann::json;
using testing::HasSubstr;

const json& vectors() {
  static const json kVectors = json::parse(std::ifstream(source_folder() + "/tests/sdk/mdns.json"));
  return kVectors;
}

std::uint16_t vector_id() { return vectors()["id"].get<std::uint16_t>(); }

std::string from_hex(const std::string& digits) {
  std::string bytes;
  for (std::size_t i = 0; i + 1 < digits.size(); i += 2)
    bytes += static_cast<char>(std::stoi(digits.substr(i, 2), nullptr, 16));
  return bytes;
}

std::optional<std::string> text_or_null(const json& value) {
  return value.is_null() ? std::nullopt : std::optional(value.get<std::string>());
}

std::vector<DiscoveredBall> balls_of(const json& one) {
  std::vector<DiscoveredBall> balls;
  for (const json& ball : one["balls"]) {
    balls.push_back({ball["name"], ball["host"],
                     Address{.host = ball["address"], .port = ball["port"], .tls = ball["tls"]},
                     text_or_null(ball["serial"]), text_or_null(ball["protocol"])});
  }
  return balls;
}

std::string balls_text(const std::vector<DiscoveredBall>& balls) {
  json all = json::array();
  for (const DiscoveredBall& ball : balls)
    all.push_back({ball.name, ball.host, to_string(ball.address), ball.serial.value_or("-"),
                   ball.protocol.value_or("-")});
  return all.dump();
}

TEST(MdnsAnswers, MatchTheVectors) {
  for (const json& one : vectors()["searches"]) {
    mdns::Answers answers(vector_id());
    for (const json& packet : one["packets"]) answers.read(from_hex(packet));
    EXPECT_EQ(balls_text(answers.balls()), balls_text(balls_of(one))) << one["name"];
    if (one.contains("query")) EXPECT_EQ(answers.query(), from_hex(one["query"])) << one["name"];
  }
}

TEST(MdnsAnswers, OfATruncatedResponseAreNone) {
  for (std::size_t i = 0; i < 3; ++i) {
    for (const json& hex : vectors()["searches"][i]["packets"]) {
      const std::string packet = from_hex(hex);
      for (std::size_t at = 0; at < packet.size(); ++at) {
        mdns::Answers answers(vector_id());
        answers.read(packet.substr(0, at));
        EXPECT_EQ(balls_text(answers.balls()), "[]") << at;
      }
    }
  }
}

TEST(MdnsAnswers, OfAFloodAreBounded) {
  mdns::Answers answers(vector_id());
  const std::string announced = from_hex(vectors()["searches"][1]["packets"][0]);
  for (int number = 0; number < 2000; ++number) {
    std::string packet = announced;
    const std::string name = std::to_string(100'000 + number);
    for (std::size_t at = 0; (at = packet.find("ball-7", at)) != packet.npos; ++at)
      packet.replace(at, name.size(), name);
    answers.read(packet);
  }
  EXPECT_EQ(answers.balls().size(), mdns::Answers::kMaxNames);
  EXPECT_LE(answers.query().size(), 1200u);
}

TEST(ChosenBall, MatchesTheVectors) {
  for (const json& one : vectors()["choices"]) {
    const auto chosen = chosen_ball(one["asked"].get<std::string>(), balls_of(one));
    if (one.contains("error")) {
      ASSERT_FALSE(chosen.has_value()) << one["name"];
      EXPECT_EQ(chosen.error().message, one["error"]);
      EXPECT_EQ(chosen.error().failure, Failure::kNoDaemon);
      continue;
    }
    ASSERT_TRUE(chosen.has_value()) << one["name"];
    json addresses = json::array();
    for (const DiscoveredBall& ball : *chosen) addresses.push_back(to_string(ball.address));
    EXPECT_EQ(addresses, one["addresses"]) << one["name"];
  }
}

TEST(MdnsAddress, MatchesTheVectors) {
  for (const json& one : vectors()["addresses"]) {
    const auto addresses = daemon_addresses(one["text"].get<std::string>(), [&](const auto& name) {
      return name == "HEDGEHOG_FINGERPRINT" ? text_or_null(one["fingerprint"]) : std::nullopt;
    });
    if (one.contains("error")) {
      ASSERT_FALSE(addresses.has_value());
      EXPECT_EQ(addresses.error().message, one["error"]);
      EXPECT_EQ(addresses.error().failure, Failure::kBadAddress);
      continue;
    }
    ASSERT_EQ(addresses->size(), 1u);
    EXPECT_EQ(to_string(addresses->front()), one["means"]);
    EXPECT_TRUE(addresses->front().tls && addresses->front().mdns);
  }
}

/// Without `tls`: a ball that was found is connected by TLS in any case.
Address mdns_address(const std::string& name) {
  return {.host = name, .mdns = true, .fingerprint = base::Sha256{}, .token = "secret"};
}

class BallSearchOnLoopback : public testing::Test {
 protected:
  static void send_query(const MdnsResponder& responder) {
    ::setenv("HEDGEHOG_MDNS_PORT", std::to_string(responder.port()).c_str(), 1);
  }
  ~BallSearchOnLoopback() override { ::unsetenv("HEDGEHOG_MDNS_PORT"); }
};

TEST_F(BallSearchOnLoopback, ListsTheRespondingBalls) {
  const MdnsResponder responder(mdns_announcement("192.0.2.7", 7586));
  send_query(responder);
  EXPECT_EQ(balls_text(discover(Milliseconds(2000)).value()),
            R"([["ball-7","lab.local","tls://192.0.2.7:7586","0007","1.0"]])");
}

TEST_F(BallSearchOnLoopback, KeepsTokenAndFingerprintOfTheAddress) {
  const MdnsResponder responder(mdns_announcement("192.0.2.7", 7586));
  send_query(responder);
  const auto located = locate({{.path = "/a.sock"}, mdns_address("0007")}).value();
  ASSERT_EQ(located.size(), 2u);
  EXPECT_EQ(located[0], Address{.path = "/a.sock"});
  EXPECT_EQ(to_string(located[1]), "tls://192.0.2.7:7586");
  EXPECT_EQ(located[1].fingerprint, base::Sha256{});
  EXPECT_EQ(located[1].token, "secret");
}

TEST_F(BallSearchOnLoopback, FindsNoBallThatDoesNotRespond) {
  const MdnsResponder silent("");
  send_query(silent);
  const auto located = locate({mdns_address("")});
  ASSERT_FALSE(located.has_value());
  EXPECT_EQ(located.error().message, "no ball answers on this network (mDNS, 1 s)");
  Address unknown = mdns_address("ball-7");
  unknown.fingerprint.reset();
  EXPECT_EQ(locate({unknown}).error().failure, Failure::kBadAddress);
}

TEST_F(BallSearchOnLoopback, ResolvesTheAddressOfABall) {
  // No listener there: the error contains the address used.
  MdnsResponder responder(mdns_announcement("127.0.0.1", 9), true);
  send_query(responder);
  hedgehog::Ball ball({mdns_address("ball-7")});
  ball.update();
  EXPECT_EQ(ball.problem(), "") << "a frame does not wait for the search";
  responder.release();
  const auto opened = ball.open();
  ASSERT_FALSE(opened.has_value());
  EXPECT_EQ(opened.error().message,
            "the daemon does not run: tls://127.0.0.1:9: connection refused");
  const auto connection = Connection::open({mdns_address("ball-7")});
  ASSERT_FALSE(connection.has_value());
  EXPECT_EQ(connection.error().message, "no daemon answers at tls://127.0.0.1:9");
}

TEST_F(BallSearchOnLoopback, ReportsWhyNoBallWasFound) {
  const MdnsResponder responder(mdns_announcement("127.0.0.1", 9));
  send_query(responder);
  hedgehog::Ball ball({mdns_address("ball-3")});
  const auto opened = ball.open();
  ASSERT_FALSE(opened.has_value());
  EXPECT_THAT(opened.error().message, HasSubstr("no ball \"ball-3\" answers"));
  EXPECT_EQ(ball.problem(), opened.error().message);
  EXPECT_GT(ball.retry_after().count(), 0);
}

}  // namespace
}  // namespace hedgehog::client
