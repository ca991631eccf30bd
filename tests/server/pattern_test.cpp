// SPDX-License-Identifier: MIT
// pattern.* with the real controller and board, as documented in protocol/README.md.
#include <gtest/gtest.h>

#include "tests/server/pattern_examples.h"

namespace hedgehog::server {
namespace {

TEST(Patterns, ArePutReadReplacedPlayedAndRemoved) {
  ServerRig rig;
  FakeClient& game = rig.connect(protocol::Role::kPlay);
  const Json put = rig.call(game, "pattern.put", knock());
  EXPECT_EQ(put, Json({{"name", "acme/knock"},
                       {"description", ""},
                       {"duration_ms", 600},
                       {"keyframes", 3},
                       {"shipped", false}}));
  EXPECT_EQ(rig.storage.files.size(), 1u);
  EXPECT_EQ(rig.call(game, "pattern.get", {{"name", "acme/knock"}})["keyframes"], kLeft);
  Json other = knock();
  other["description"] = "louder";
  rig.call(game, "pattern.put", other);
  EXPECT_EQ(rig.call(game, "pattern.get", {{"name", "acme/knock"}})["description"], "louder");
  EXPECT_EQ(rig.call(game, "effect.play", {{"pattern", "acme/knock"}})["accepted"], true);
  EXPECT_EQ(rig.call(game, "pattern.remove", {{"name", "acme/knock"}}), Json::object());
  EXPECT_TRUE(rig.storage.files.empty());
  EXPECT_EQ(rig.call(game, "pattern.get", {{"name", "acme/knock"}})["code"], -32008);
  rig.run(100);
  EXPECT_GT(rig.plant_current_a(), 2.0) << "what plays is not touched";
}

TEST(Patterns, ShippedAndInvalidNamesAreRefused) {
  ServerRig rig;
  FakeClient& game = rig.connect();
  for (const char* name : {"tick", "mine", "Acme/knock", "acme/", "/x", "a/b/c", "../x", "a/..b"}) {
    const Json refused = rig.call(game, "pattern.put", knock(name));
    EXPECT_EQ(refused["code"], -32602) << name;
    EXPECT_EQ(refused["data"]["field"], "name") << name;
  }
  EXPECT_EQ(rig.call(game, "pattern.remove", {{"name", "tick"}})["code"], -32602);
  EXPECT_EQ(rig.call(game, "pattern.remove", {{"name", "acme/tick"}})["code"], -32008);
  EXPECT_TRUE(rig.storage.files.empty());
}

TEST(Patterns, ReadingNeedsObserveAndPuttingNeedsPlay) {
  ServerRig rig;
  FakeClient& observer = rig.connect(protocol::Role::kObserve);
  EXPECT_TRUE(rig.call(observer, "pattern.list").contains("patterns"));
  EXPECT_TRUE(rig.call(observer, "pattern.get", {{"name", "tick"}}).contains("keyframes"));
  EXPECT_EQ(rig.call(observer, "pattern.put", knock())["code"], -32004);
  EXPECT_EQ(rig.call(observer, "pattern.remove", {{"name", "acme/knock"}})["code"], -32004);
  EXPECT_EQ(rig.call(observer, "effect.play", {{"pattern", "tick"}})["code"], -32004);
}

TEST(Patterns, AreLimitedTo256) {
  ServerRig rig;
  FakeClient& game = rig.connect();
  for (int i = 0; i < 256; ++i)
    ASSERT_TRUE(rig.call(game, "pattern.put", knock("acme/" + std::to_string(i))).contains("name"));
  const Json refused = rig.call(game, "pattern.put", knock("acme/more"));
  EXPECT_EQ(refused["code"], -32001);
  EXPECT_EQ(refused["data"]["limit"], 256);
  EXPECT_TRUE(rig.call(game, "pattern.put", knock("acme/7")).contains("name")) << "known already";
  rig.call(game, "pattern.remove", {{"name", "acme/7"}});
  EXPECT_TRUE(rig.call(game, "pattern.put", knock("acme/more")).contains("name"));
}

TEST(Patterns, ABatchWithLongResponsesIsTruncatedAndItsClientStays) {
  ServerRig rig;
  FakeClient& game = rig.connect();
  Json frames = Json::array();
  for (int i = 0; i < 256; ++i) {
    frames.push_back({{"t_ms", 10 * i},
                      {"direction", {0.123456789012 + i, -0.345678901234, 0.567890123456}},
                      {"level", 0.512345678912}});
  }
  rig.call(game, "pattern.put", {{"name", "acme/long"}, {"keyframes", frames}});
  Json batch = Json::array();
  for (int i = 0; i < 62; ++i) {
    batch.push_back({{"jsonrpc", "2.0"},
                     {"id", i},
                     {"method", "pattern.get"},
                     {"params", {{"name", "acme/long"}}}});
  }
  batch.push_back({{"jsonrpc", "2.0"}, {"id", "arm"}, {"method", "device.arm"}});
  batch.push_back({{"jsonrpc", "2.0"}, {"id", "stop"}, {"method", "device.emergency_stop"}});
  const Json responses = rig.exchange(game, batch.dump());
  ASSERT_EQ(responses.size(), 64u);
  EXPECT_EQ(responses[0]["result"]["keyframes"].size(), 256u);
  EXPECT_EQ(responses[61]["error"]["code"], -32001);
  EXPECT_EQ(responses[62]["error"]["code"], -32001) << "in order, whatever it is";
  EXPECT_EQ(responses[63]["result"]["state"], "disarmed") << "but for the stop";
  EXPECT_LT(responses.dump().size(), game.session.batch_bytes + 65'536);
}

TEST(Patterns, ADiskErrorIsReported) {
  ServerRig rig;
  rig.storage.problem = "no space left";
  FakeClient& game = rig.connect();
  const Json put = rig.call(game, "pattern.put", knock());
  EXPECT_EQ(put["code"], -32603);
  EXPECT_EQ(put["message"],
            "internal_error: applied, but writing to disk failed, so a restart may undo it: no "
            "space left");
  const Json removed = rig.call(game, "pattern.remove", {{"name", "acme/knock"}});
  EXPECT_EQ(removed["message"],
            "internal_error: applied, but writing to disk failed, so a restart may undo it: no "
            "space left");
}

TEST(Patterns, WhileTheDiskQueueIsFullNothingIsChanged) {
  ServerRig rig;
  FakeClient& game = rig.connect();
  rig.call(game, "pattern.put", knock());
  rig.storage.full = true;
  Json louder = knock();
  louder["description"] = "louder";
  for (const Json& refused :
       {rig.call(game, "pattern.put", louder), rig.call(game, "pattern.put", knock("acme/other")),
        rig.call(game, "pattern.remove", {{"name", "acme/knock"}})}) {
    EXPECT_EQ(refused["code"], -32001);
    EXPECT_GT(refused["data"]["retry_after_ms"], 0);
  }
  EXPECT_FALSE(rig.call(game, "pattern.get", {{"name", "acme/knock"}}).contains("description"));
  EXPECT_EQ(rig.call(game, "pattern.get", {{"name", "acme/other"}})["code"], -32008);
  rig.storage.full = false;
  for (int i = 0; i < 255; ++i) {
    ASSERT_TRUE(rig.call(game, "pattern.put", knock("acme/" + std::to_string(i))).contains("name"))
        << "what was refused has taken no place";
  }
}

TEST(Patterns, TheListIsCurrentAndFitsALineWithAnyDescriptions) {
  ServerRig rig;
  FakeClient& game = rig.connect();
  const auto listed = [&](const std::string& name) {
    const Json list = rig.call(game, "pattern.list");
    for (const Json& one : list["patterns"])
      if (one["name"] == name) return one;
    return Json();
  };
  EXPECT_TRUE(listed("acme/knock").is_null());
  Json put = knock();
  std::string description;
  for (int i = 0; i < 256; ++i) description += "\xF0\x9F\xA6\x94";  // characters of four bytes
  put["description"] = description;
  rig.call(game, "pattern.put", put);
  EXPECT_EQ(listed("acme/knock")["description"], put["description"]);
  for (int i = 1; i < 256; ++i) {
    const std::string number = std::to_string(1000 + i);
    put["name"] = std::string(32, 'v') + "/" + std::string(28, 'p') + number;
    ASSERT_TRUE(rig.call(game, "pattern.put", put).contains("name"));
  }
  rig.server->line(game.session, R"({"jsonrpc":"2.0","id":1,"method":"pattern.list"})");
  ASSERT_EQ(game.lines.size(), 1u);
  EXPECT_LE(game.lines.front().text.size(), 65'536u);
  game.lines.clear();
  EXPECT_EQ(listed("acme/knock")["description"], "");
  EXPECT_FALSE(listed("tick")["description"].get<std::string>().empty());
  EXPECT_EQ(rig.call(game, "pattern.get", {{"name", "acme/knock"}})["description"],
            put["description"]);
  rig.call(game, "pattern.remove", {{"name", "acme/knock"}});
  EXPECT_TRUE(listed("acme/knock").is_null());
}

TEST(Patterns, ABatchIsLimitedToEightLists) {
  ServerRig rig;
  FakeClient& game = rig.connect(protocol::Role::kObserve);
  Json batch = Json::array();
  for (int i = 0; i < 64; ++i)
    batch.push_back({{"jsonrpc", "2.0"}, {"id", i}, {"method", "pattern.list"}});
  const Json responses = rig.exchange(game, batch.dump());
  ASSERT_EQ(responses.size(), 64u);
  for (std::size_t i = 0; i < 64; ++i) EXPECT_EQ(responses[i].contains("result"), i < 8) << i;
  EXPECT_EQ(responses[8]["error"]["data"]["limit"], 8);
  EXPECT_EQ(rig.exchange(game, batch.dump())[7].contains("result"), true)
      << "the next batch has its own";
}

}  // namespace
}  // namespace hedgehog::server
