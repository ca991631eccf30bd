// SPDX-License-Identifier: MIT
// The game's web server: access, requests of the pages, and that no page can block it.
#include "clients/racer/server/server.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <future>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "tests/e2e/web_client.h"
#include "tests/temporary_folder.h"

namespace hedgehog::racer {
namespace {

using e2e::Json;
using e2e::WebAnswer;
using e2e::WebSocketClient;
using std::chrono::milliseconds;
using std::chrono::steady_clock;
using testing::HasSubstr;

constexpr const char* kPage = "<!doctype html><p>race</p>";

Track a_track() {
  Track track;
  track.centre = {{0, 0, 0}, {20, 0, 0}, {20, 20, 0}};
  track.obstacles.resize(20);
  return track;
}

Scene scene_at(double time_s, std::size_t obstacles = 20) {
  Scene scene;
  scene.time_s = time_s;
  scene.obstacles.resize(obstacles);
  return scene;
}

class GameServer : public testing::Test {
 protected:
  /// Result of `work` in another thread, while this one runs the server as a game does.
  template <class Work>
  auto served(Work work) {
    auto result = std::async(std::launch::async, work);
    while (result.wait_for(milliseconds{0}) != std::future_status::ready) serve();
    return result.get();
  }
  void serve() { server_.serve_until(steady_clock::now() + milliseconds{1}); }
  /// Runs the server until `holds` is true of the pages' requests; returns them.
  template <class Holds>
  PageRequests asked_until(Holds holds) {
    for (;;) {
      serve();
      const PageRequests asked = server_.take(kLongAgo);
      if (holds(asked)) return asked;
    }
  }
  WebAnswer get(const std::string& target, const std::string& more = "",
                const std::string& method = "GET") {
    return served([&] { return e2e::web_get(port(), target, more, method); });
  }
  /// Connects a page; if it is accepted, waits until the server counts it.
  std::unique_ptr<WebSocketClient> page(const std::string& more = "") {
    const int before = server_.pages();
    auto client = served([&] { return std::make_unique<WebSocketClient>(port(), more); });
    while (client->answer().status == 101 && server_.pages() == before) serve();
    return client;
  }
  Json heard(WebSocketClient& page) {
    return served([&] { return page.json(); });
  }
  int port() const { return server_.port(); }

  /// No lease has expired at this time; tests of leases use another one.
  static constexpr steady_clock::time_point kLongAgo{};

  TemporaryFolder folder_;
  Server server_ = [this] {
    folder_.write("index.html", kPage);
    return Server({.port = 0, .pages = folder_.path()}, a_track());
  }();
};

TEST_F(GameServer, ServesThePageWithStrictHeaders) {
  const WebAnswer page = get("/");
  EXPECT_EQ(page.status, 200);
  EXPECT_EQ(page.body, kPage);
  EXPECT_EQ(page.header("content-type"), "text/html; charset=utf-8");
  EXPECT_THAT(page.header("content-security-policy"), HasSubstr("default-src 'none'"));
  EXPECT_EQ(page.header("x-content-type-options"), "nosniff");
  EXPECT_EQ(get("/", "", "HEAD").body, "");
  EXPECT_EQ(get("/index.html?x=1").status, 200);
  EXPECT_EQ(get("/../etc/passwd").status, 404);
  EXPECT_EQ(get("/", "", "POST").status, 405);
  const auto say = [this](const std::string& bytes) {
    return served([&] { return e2e::web_say(port(), bytes); });
  };
  EXPECT_EQ(say("nonsense\r\n\r\n").status, 400);
  EXPECT_EQ(say(std::string(20'000, 'x')).status, 400);
  EXPECT_EQ(get("/").status, 200);
}

TEST_F(GameServer, SaysHowThePageIsBuiltWhereItIsMissing) {
  Server bare({.port = 0, .pages = "/no/<such>/folder"}, a_track());
  auto asked = std::async(std::launch::async, [&] { return e2e::web_get(bare.port(), "/"); });
  while (asked.wait_for(milliseconds{0}) != std::future_status::ready)
    bare.serve_until(steady_clock::now() + milliseconds{1});
  const WebAnswer answer = asked.get();
  EXPECT_EQ(answer.status, 200);
  EXPECT_THAT(answer.body, HasSubstr("make race"));
  EXPECT_THAT(answer.body, HasSubstr("/no/&lt;such&gt;/folder"));
}

TEST_F(GameServer, RefusesForeignNamesAndForeignPages) {
  const std::string own = "127.0.0.1:" + std::to_string(port());
  EXPECT_EQ(get("/", "Host: rebound.example:" + std::to_string(port()) + "\r\n").status, 421);
  EXPECT_EQ(get("/", "Host: rebound.example\r\n").status, 421);
  EXPECT_EQ(get("/", "Host: 127.0.0.1:1\r\n").status, 200) << "as ssh -L gives one";
  EXPECT_EQ(page("Origin: http://127.0.0.1:1\r\n")->answer().status, 403);
  EXPECT_EQ(get("/", "Host: " + own + "\r\nHost: " + own + "\r\n").status, 421);
  EXPECT_EQ(get("/", "Origin: http://evil.example\r\n").status, 403);
  EXPECT_EQ(page("Origin: http://" + own + "\r\n")->answer().status, 101);
  EXPECT_EQ(page("Origin: http://evil.example\r\n")->answer().status, 403);
  EXPECT_EQ(page("Origin: null\r\n")->answer().status, 403);
  EXPECT_EQ(page("Host: rebound.example\r\nOrigin: http://rebound.example\r\n")->answer().status,
            421);
}

TEST_F(GameServer, TellsTheTrackFirstThenWhatHappens) {
  const auto page = this->page();
  EXPECT_EQ(heard(*page)["type"], "track");
  server_.publish(Felt{"hit", {0, 1, 0}, 0.5, 6.0});
  server_.publish(scene_at(1.5), {Mode::kDriver, true});
  server_.publish(
      BallView{.connected = true, .state = "armed", .temperature_c = 41.0, .gain = 0.8});
  const Json hit = heard(*page);
  EXPECT_EQ(hit["type"], "felt");
  EXPECT_EQ(hit["direction"], Json({0.0, 1.0, 0.0}));
  const Json scene = heard(*page);
  EXPECT_EQ(scene["time_s"], 1.5);
  EXPECT_EQ(scene["mode"], "driver");
  EXPECT_EQ(scene["paused"], true);
  EXPECT_EQ(scene["obstacles"].size(), 20u);
  EXPECT_EQ(heard(*page)["gain"], 0.8);
}

TEST_F(GameServer, AnswersNonsenseAndLivesOn) {
  const auto page = this->page();
  heard(*page);
  page->text("nonsense");
  EXPECT_EQ(heard(*page)["type"], "refused");
  page->text(R"({"type":"keys","steer":7})");
  EXPECT_THAT(heard(*page)["why"], HasSubstr("steer must be -1 to 1"));
  page->text(std::string(Hub::kMaxReceivedBytes + 1, ' '));
  const auto last = served([&] { return page->next(); });
  EXPECT_TRUE(!last || last->opcode == WebSocketClient::kClose);
  EXPECT_EQ(get("/").status, 200);
}

TEST_F(GameServer, TheHandThatPressedLastSteersAndLetsGoWhenItLeaves) {
  auto one = page();
  const auto other = page();
  one->text(R"({"type":"keys","steer":1,"throttle":1})");
  asked_until([](const PageRequests& asked) { return asked.keys == Controls{1.0, 1.0, 0.0}; });
  other->text(R"({"type":"keys"})");  // releases keys that it never pressed
  other->text(R"({"type":"reset"})");
  EXPECT_EQ(asked_until([](const PageRequests& asked) { return asked.reset; }).keys,
            (Controls{1.0, 1.0, 0.0}));
  EXPECT_FALSE(server_.take(kLongAgo).reset);
  other->text(R"({"type":"keys","brake":1})");
  asked_until([](const PageRequests& asked) { return asked.keys == Controls{0.0, 0.0, 1.0}; });
  one->text(R"({"type":"keys","steer":-1})");
  asked_until([](const PageRequests& asked) { return asked.keys == Controls{-1.0, 0.0, 0.0}; });
  one.reset();
  asked_until([](const PageRequests& asked) { return asked.keys == Controls{}; });
  EXPECT_EQ(server_.pages(), 1);
}

TEST_F(GameServer, AHandThatHoldsDoesNotTakeTheWheelFromTheOneThatPressedLast) {
  const auto one = page();
  const auto other = page();
  one->text(R"({"type":"keys","throttle":1})");
  asked_until([](const PageRequests& asked) { return asked.keys.throttle == 1.0; });
  other->text(R"({"type":"keys","brake":1})");
  asked_until([](const PageRequests& asked) { return asked.keys.brake == 1.0; });
  one->text(R"({"type":"keys","throttle":1})");  // still pressed
  one->text(R"({"type":"reset"})");
  EXPECT_EQ(asked_until([](const PageRequests& asked) { return asked.reset; }).keys,
            (Controls{0.0, 0.0, 1.0}));
}

TEST_F(GameServer, AHandThatIsNotHeardHasLetGo) {
  const auto page = this->page();
  page->text(R"({"type":"keys","throttle":1})");
  asked_until([](const PageRequests& asked) { return asked.keys.throttle == 1.0; });
  const auto now = steady_clock::now();
  EXPECT_EQ(server_.take(now + Server::kKeysLease + milliseconds{1}).keys, Controls{});
}

TEST_F(GameServer, APageThatReadsSlowlyLosesFramesAndHoldsNobodyUp) {
  // Ten times the size of the kernel's buffers for a connection.
  constexpr int kFrames = 150;
  const auto slow = page();
  const auto quick = page();
  // Or until the game has closed the connection.
  const auto frames_until_the_last = [](WebSocketClient& page) {
    for (int frames = 0;; ++frames) {
      const auto frame = page.next();
      if (!frame) return frames;
      if (frame->payload.find(R"("time_s":150.0)") != std::string::npos) return frames;
    }
  };
  // Each frame is sent when the quick page has received the previous one; the slow page reads
  // nothing meanwhile.
  std::atomic<int> told{0};
  auto reader = std::async(std::launch::async, [&] {
    while (told < kFrames) {
      const auto frame = quick->next();
      if (!frame) return false;
      if (frame->payload.find(R"("type":"scene")") == std::string::npos) continue;
      const std::string time = R"("time_s":)" + std::to_string(++told) + ".0";
      if (frame->payload.find(time) == std::string::npos) return false;
    }
    return true;
  });
  for (int i = 1; i <= kFrames; ++i) {
    server_.publish(scene_at(i, 500), {});
    while (told < i && reader.wait_for(milliseconds{0}) != std::future_status::ready) serve();
  }
  EXPECT_TRUE(reader.get()) << "the quick page gets every frame";
  const int seen = served([&] { return frames_until_the_last(*slow); });
  EXPECT_GT(seen, 0);
  EXPECT_LT(seen, kFrames / 2);
}

TEST_F(GameServer, HasRoomForSomePagesAndSaysWhenItIsFull) {
  std::vector<std::unique_ptr<WebSocketClient>> pages;
  // The open pages answer no ping, and send messages instead.
  const auto one_more = [&] {
    for (const auto& open : pages) open->text(R"({"type":"keys"})");
    return page();
  };
  for (int i = 0; i < Hub::kMaxPages; ++i) {
    pages.push_back(one_more());
    ASSERT_EQ(pages.back()->answer().status, 101);
  }
  EXPECT_EQ(one_more()->answer().status, 503);
  pages.pop_back();
  while (server_.pages() == Hub::kMaxPages) serve();
  EXPECT_EQ(one_more()->answer().status, 101);
}

TEST_F(GameServer, TakesItsLeaveInWords) {
  const auto page = this->page();
  heard(*page);
  // Its timeout is short; on a busy machine a second attempt may be necessary.
  auto last = std::async(std::launch::async, [&] { return page->json(); });
  while (last.wait_for(milliseconds{0}) != std::future_status::ready)
    server_.announce_shutdown("somebody pressed Ctrl-C");
  EXPECT_EQ(last.get(), (Json{{"type", "goodbye"}, {"reason", "somebody pressed Ctrl-C"}}));
}

TEST_F(GameServer, APortThatIsTakenIsASentence) {
  try {
    Server second({.port = server_.port(), .pages = ""}, a_track());
    FAIL() << "listens on a port that is taken";
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), HasSubstr("cannot listen on 127.0.0.1:"));
    EXPECT_THAT(error.what(), HasSubstr("--listen"));
  }
}

}  // namespace
}  // namespace hedgehog::racer
