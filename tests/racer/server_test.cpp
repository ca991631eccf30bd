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
using e2e::WebResponse;
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
  PageRequests requests_until(Holds holds) {
    for (;;) {
      serve();
      const PageRequests requests = server_.take(kLongAgo);
      if (holds(requests)) return requests;
    }
  }
  WebResponse get(const std::string& target, const std::string& more = "",
                  const std::string& method = "GET") {
    return served([&] { return e2e::web_get(port(), target, more, method); });
  }
  /// Connects a page; if it is accepted, waits until the server counts it.
  std::unique_ptr<WebSocketClient> page(const std::string& more = "") {
    const int before = server_.pages();
    auto client = served([&] { return std::make_unique<WebSocketClient>(port(), more); });
    while (client->response().status == 101 && server_.pages() == before) serve();
    return client;
  }
  Json next_message(WebSocketClient& page) {
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
  const WebResponse page = get("/");
  EXPECT_EQ(page.status, 200);
  EXPECT_EQ(page.body, kPage);
  EXPECT_EQ(page.header("content-type"), "text/html; charset=utf-8");
  EXPECT_THAT(page.header("content-security-policy"), HasSubstr("default-src 'none'"));
  EXPECT_EQ(page.header("x-content-type-options"), "nosniff");
  EXPECT_EQ(get("/", "", "HEAD").body, "");
  EXPECT_EQ(get("/index.html?x=1").status, 200);
  EXPECT_EQ(get("/../etc/passwd").status, 404);
  EXPECT_EQ(get("/", "", "POST").status, 405);
  const auto send = [this](const std::string& bytes) {
    return served([&] { return e2e::web_send(port(), bytes); });
  };
  EXPECT_EQ(send("nonsense\r\n\r\n").status, 400);
  EXPECT_EQ(send(std::string(20'000, 'x')).status, 400);
  EXPECT_EQ(get("/").status, 200);
}

TEST_F(GameServer, ExplainsHowAMissingPageIsBuilt) {
  Server without_pages({.port = 0, .pages = "/no/<such>/folder"}, a_track());
  auto requests =
      std::async(std::launch::async, [&] { return e2e::web_get(without_pages.port(), "/"); });
  while (requests.wait_for(milliseconds{0}) != std::future_status::ready)
    without_pages.serve_until(steady_clock::now() + milliseconds{1});
  const WebResponse response = requests.get();
  EXPECT_EQ(response.status, 200);
  EXPECT_THAT(response.body, HasSubstr("make race"));
  EXPECT_THAT(response.body, HasSubstr("/no/&lt;such&gt;/folder"));
}

TEST_F(GameServer, RefusesForeignNamesAndForeignPages) {
  const std::string own = "127.0.0.1:" + std::to_string(port());
  EXPECT_EQ(get("/", "Host: rebound.example:" + std::to_string(port()) + "\r\n").status, 421);
  EXPECT_EQ(get("/", "Host: rebound.example\r\n").status, 421);
  EXPECT_EQ(get("/", "Host: 127.0.0.1:1\r\n").status, 200) << "as ssh -L gives one";
  EXPECT_EQ(page("Origin: http://127.0.0.1:1\r\n")->response().status, 403);
  EXPECT_EQ(get("/", "Host: " + own + "\r\nHost: " + own + "\r\n").status, 421);
  EXPECT_EQ(get("/", "Origin: http://evil.example\r\n").status, 403);
  EXPECT_EQ(page("Origin: http://" + own + "\r\n")->response().status, 101);
  EXPECT_EQ(page("Origin: http://evil.example\r\n")->response().status, 403);
  EXPECT_EQ(page("Origin: null\r\n")->response().status, 403);
  EXPECT_EQ(page("Host: rebound.example\r\nOrigin: http://rebound.example\r\n")->response().status,
            421);
}

TEST_F(GameServer, SendsTheTrackFirstThenTheEvents) {
  const auto page = this->page();
  EXPECT_EQ(next_message(*page)["type"], "track");
  server_.publish(Felt{"hit", {0, 1, 0}, 0.5, 6.0});
  server_.publish(scene_at(1.5), {Mode::kDriver, true});
  server_.publish(
      BallView{.connected = true, .state = "armed", .temperature_c = 41.0, .gain = 0.8});
  const Json hit = next_message(*page);
  EXPECT_EQ(hit["type"], "felt");
  EXPECT_EQ(hit["direction"], Json({0.0, 1.0, 0.0}));
  const Json scene = next_message(*page);
  EXPECT_EQ(scene["time_s"], 1.5);
  EXPECT_EQ(scene["mode"], "driver");
  EXPECT_EQ(scene["paused"], true);
  EXPECT_EQ(scene["obstacles"].size(), 20u);
  EXPECT_EQ(next_message(*page)["gain"], 0.8);
}

TEST_F(GameServer, RefusesInvalidMessagesAndContinues) {
  const auto page = this->page();
  next_message(*page);
  page->text("nonsense");
  EXPECT_EQ(next_message(*page)["type"], "refused");
  page->text(R"({"type":"keys","steer":7})");
  EXPECT_THAT(next_message(*page)["why"], HasSubstr("steer must be -1 to 1"));
  page->text(std::string(Hub::kMaxReceivedBytes + 1, ' '));
  const auto last = served([&] { return page->next(); });
  EXPECT_TRUE(!last || last->opcode == WebSocketClient::kClose);
  EXPECT_EQ(get("/").status, 200);
}

TEST_F(GameServer, ThePageWithTheLastKeyPressSteersUntilItDisconnects) {
  auto one = page();
  const auto other = page();
  one->text(R"({"type":"keys","steer":1,"throttle":1})");
  requests_until([](const PageRequests& requests) {
    return requests.keys == Controls{1.0, 1.0, 0.0};
  });
  other->text(R"({"type":"keys"})");  // releases keys that it never pressed
  other->text(R"({"type":"reset"})");
  EXPECT_EQ(requests_until([](const PageRequests& requests) { return requests.reset; }).keys,
            (Controls{1.0, 1.0, 0.0}));
  EXPECT_FALSE(server_.take(kLongAgo).reset);
  other->text(R"({"type":"keys","brake":1})");
  requests_until([](const PageRequests& requests) {
    return requests.keys == Controls{0.0, 0.0, 1.0};
  });
  one->text(R"({"type":"keys","steer":-1})");
  requests_until([](const PageRequests& requests) {
    return requests.keys == Controls{-1.0, 0.0, 0.0};
  });
  one.reset();
  requests_until([](const PageRequests& requests) { return requests.keys == Controls{}; });
  EXPECT_EQ(server_.pages(), 1);
}

TEST_F(GameServer, ARepeatedKeyDoesNotOverrideALaterKeyPressOfAnotherPage) {
  const auto one = page();
  const auto other = page();
  one->text(R"({"type":"keys","throttle":1})");
  requests_until([](const PageRequests& requests) { return requests.keys.throttle == 1.0; });
  other->text(R"({"type":"keys","brake":1})");
  requests_until([](const PageRequests& requests) { return requests.keys.brake == 1.0; });
  one->text(R"({"type":"keys","throttle":1})");  // still pressed
  one->text(R"({"type":"reset"})");
  EXPECT_EQ(requests_until([](const PageRequests& requests) { return requests.reset; }).keys,
            (Controls{0.0, 0.0, 1.0}));
}

TEST_F(GameServer, ControlsOfASilentPageExpire) {
  const auto page = this->page();
  page->text(R"({"type":"keys","throttle":1})");
  requests_until([](const PageRequests& requests) { return requests.keys.throttle == 1.0; });
  const auto now = steady_clock::now();
  EXPECT_EQ(server_.take(now + Server::kKeysLease + milliseconds{1}).keys, Controls{});
}

TEST_F(GameServer, ASlowPageLosesFramesAndDelaysNoOther) {
  // Ten times the size of the kernel's buffers for a connection.
  constexpr int kFrames = 150;
  const auto slow = page();
  const auto quick = page();
  // Or until the game has closed the connection.
  const auto count_frames = [](WebSocketClient& page) {
    for (int frames = 0;; ++frames) {
      const auto frame = page.next();
      if (!frame) return frames;
      if (frame->payload.find(R"("time_s":150.0)") != std::string::npos) return frames;
    }
  };
  // Each frame is sent when the quick page has received the previous one; the slow page reads
  // nothing meanwhile.
  std::atomic<int> received{0};
  auto reader = std::async(std::launch::async, [&] {
    while (received < kFrames) {
      const auto frame = quick->next();
      if (!frame) return false;
      if (frame->payload.find(R"("type":"scene")") == std::string::npos) continue;
      const std::string time = R"("time_s":)" + std::to_string(++received) + ".0";
      if (frame->payload.find(time) == std::string::npos) return false;
    }
    return true;
  });
  for (int i = 1; i <= kFrames; ++i) {
    server_.publish(scene_at(i, 500), {});
    while (received < i && reader.wait_for(milliseconds{0}) != std::future_status::ready) serve();
  }
  EXPECT_TRUE(reader.get()) << "the quick page gets every frame";
  const int seen = served([&] { return count_frames(*slow); });
  EXPECT_GT(seen, 0);
  EXPECT_LT(seen, kFrames / 2);
}

TEST_F(GameServer, LimitsTheNumberOfPages) {
  std::vector<std::unique_ptr<WebSocketClient>> pages;
  // The open pages answer no ping, and send messages instead.
  const auto one_more = [&] {
    for (const auto& open : pages) open->text(R"({"type":"keys"})");
    return page();
  };
  for (int i = 0; i < Hub::kMaxPages; ++i) {
    pages.push_back(one_more());
    ASSERT_EQ(pages.back()->response().status, 101);
  }
  EXPECT_EQ(one_more()->response().status, 503);
  pages.pop_back();
  while (server_.pages() == Hub::kMaxPages) serve();
  EXPECT_EQ(one_more()->response().status, 101);
}

TEST_F(GameServer, AnnouncesItsShutdown) {
  const auto page = this->page();
  next_message(*page);
  // Its timeout is short; on a busy machine a second attempt may be necessary.
  auto last = std::async(std::launch::async, [&] { return page->json(); });
  while (last.wait_for(milliseconds{0}) != std::future_status::ready)
    server_.announce_shutdown("somebody pressed Ctrl-C");
  EXPECT_EQ(last.get(), (Json{{"type", "goodbye"}, {"reason", "somebody pressed Ctrl-C"}}));
}

TEST_F(GameServer, AnAddressThatOtherMachinesReachIsRefused) {
  for (const char* address : {"0.0.0.0", "::", "192.168.7.5"}) {
    try {
      Server reachable({.address = address, .port = 0, .pages = ""}, a_track());
      FAIL() << "listens on " << address;
    } catch (const std::runtime_error& error) {
      EXPECT_THAT(error.what(), HasSubstr("without TLS and token"));
      EXPECT_THAT(error.what(), HasSubstr("ssh -L"));
    }
  }
}

TEST_F(GameServer, APortInUseIsReported) {
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
