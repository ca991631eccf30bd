// SPDX-License-Identifier: MIT
// A client that does not read its responses: which requests are still carried out, and when it is
// disconnected.
#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <string>
#include <system_error>
#include <thread>

#include "tests/e2e/timeout.h"
#include "tests/e2e/web_fixture.h"

namespace hedgehog::e2e {
namespace {

/// The responses, 10 kB each, exceed what the system buffers for a client.
constexpr int kUnread = 1500;

std::string line(const Json& id, const std::string& method, const Json& params = Json::object()) {
  return Json{{"jsonrpc", "2.0"}, {"id", id}, {"method", method}, {"params", params}}.dump() + "\n";
}

std::string many_requests() {
  std::string all;
  for (int i = 0; i < kUnread; ++i) all += line("many", "device.describe");
  return all;
}

/// With io_uring, skipped where the kernel refuses it, and without.
class Flow : public testing::TestWithParam<bool> {
 protected:
  static void SetUpTestSuite() {
    const Home home;
    DaemonProcess daemon(home);
    has_ring = daemon.log().find("io_uring is not used") == std::string::npos;
  }
  void SetUp() override {
    if (GetParam() && !has_ring) GTEST_SKIP() << "the kernel refuses io_uring";
  }
  static inline bool has_ring = false;

  struct TimeoutHome : Home {
    explicit TimeoutHome(int write_timeout_s) {
      configure(
          Json{{"connections",
                {{"write_timeout_s", write_timeout_s}, {"io_uring_after", GetParam() ? 0 : 1024}}}}
              .dump());
    }
  };
};

class HeldBack : public Flow {
 protected:
  HeldBack() { watcher_.call("events.subscribe", {{"scope", "all"}}); }
  bool reaches(const std::string& state) {
    return wait_until([&] { return watcher_.call("device.status")["state"] == state; });
  }

  /// No client is disconnected for reading slowly.
  const TimeoutHome home_{600};
  DaemonProcess daemon_{home_};
  RawClient watcher_{daemon_.port()};
};

TEST_P(HeldBack, AnEmergencyStopIsExecutedAtOnceAndEarlierRequestsDoNotArm) {
  RawClient client(daemon_.port());
  client.send(many_requests() + line("arm", "device.arm") +
              line("push", "effect.hold", {{"direction", "left"}}) +
              line("stop", "device.emergency_stop"));
  EXPECT_TRUE(reaches("disarmed"));
  int described = 0;
  Json responses;
  while (described < kUnread || responses.size() < 3) {
    const Json response = client.response();
    if (response["id"] == "many")
      described += response.contains("result");
    else
      responses[response["id"].get<std::string>()] = response;
  }
  EXPECT_EQ(described, kUnread);
  EXPECT_EQ(responses["stop"]["result"]["state"], "disarmed");
  EXPECT_EQ(responses["arm"]["error"]["code"], -32001);
  EXPECT_EQ(responses["push"]["error"]["code"], -32001);
  EXPECT_EQ(watcher_.call("device.status")["state"], "disarmed");
  EXPECT_EQ(client.call("device.arm")["state"], "armed") << "what comes after it is carried out";
}

TEST_P(HeldBack, RequestsAfterTheStopAreExecutedWhileOlderOnesAreHeld) {
  RawClient client(daemon_.port());
  client.send(many_requests() + line("stop", "device.emergency_stop"));
  ASSERT_TRUE(reaches("disarmed"));
  client.send(line("arm", "device.arm"));
  Json response;
  do response = client.response();
  while (response["id"] != "arm");
  EXPECT_EQ(response["result"]["state"], "armed") << response;
}

TEST_P(HeldBack, OnTheUnixSocketToo) {
  RawClient client(daemon_.socket());
  client.send(many_requests() + line("stop", "device.emergency_stop"));
  EXPECT_TRUE(reaches("disarmed"));
}

TEST_P(HeldBack, OnWebSocketToo) {
  WebSocketClient client(daemon_.http_port());
  for (int i = 0; i < kUnread; ++i) client.text(line("many", "device.describe"));
  client.text(line("stop", "device.emergency_stop"));
  EXPECT_TRUE(reaches("disarmed"));
}

TEST_P(HeldBack, AHalfCloseEndsTheEffectsAtOnceAndTheResponsesAreSent) {
  RawClient client(daemon_.port());
  client.send(line("hold", "effect.hold", {{"direction", "left"}, {"lease_ms", 10000}}) +
              many_requests());
  EXPECT_EQ(watcher_.notification("event", "effect_started")["type"], "effect_started");
  client.half_close();
  EXPECT_EQ(watcher_.notification("event", "effect_ended")["reason"], "disconnected");
  EXPECT_EQ(client.response()["id"], "hold");
  for (int i = 0; i < kUnread; ++i) ASSERT_EQ(client.response()["id"], "many") << i;
  EXPECT_TRUE(client.closed_by_daemon());
}

TEST_P(HeldBack, AFloodOfStopsStopsTheBallAndEndsWithItsConnection) {
  RawClient client(daemon_.port());
  client.send(many_requests());
  std::string stops;
  for (int i = 0; i < 200; ++i) stops += line(i, "device.emergency_stop");
  bool open = true;
  for (int i = 0; i < 10'000 && open; ++i) open = client.send(stops);
  EXPECT_FALSE(open) << "its answers fill its queue";
  EXPECT_TRUE(daemon_.logs("does not read"));
  EXPECT_TRUE(reaches("disarmed"));
  EXPECT_TRUE(
      wait_until([&] { return watcher_.call("connection.list")["connections"].size() == 1; }));
}

class ReadSlowly : public Flow {};

TEST_P(ReadSlowly, IsNotDisconnectedWhileItReadsAnything) {
  constexpr std::chrono::seconds kWriteTimeout{2};
  const TimeoutHome home(static_cast<int>(kWriteTimeout.count()));
  DaemonProcess daemon(home);
  RawClient client(daemon.port(), 16 * 1024);
  client.send(many_requests());
  // By the clock, as the daemon's timeout is: the ball's time passes more slowly on a busy
  // computer.
  const auto end = std::chrono::steady_clock::now() + 3 * kWriteTimeout;
  while (std::chrono::steady_clock::now() < end) {
    ASSERT_TRUE(client.bytes(4096));
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
  client.half_close();
  while (client.bytes()) {
  }
  EXPECT_EQ(daemon.log().find("does not read"), std::string::npos) << daemon.log();
}

TEST_P(ReadSlowly, IsDisconnectedIfItReadsNothingAlsoAfterHavingReadAll) {
  // While it reads, a busy machine may stop it for seconds.
  const TimeoutHome home(10);
  DaemonProcess daemon(home);
  RawClient client(daemon.port());
  client.send(many_requests());
  for (int i = 0; i < kUnread; ++i) ASSERT_EQ(client.response()["id"], "many") << i;
  EXPECT_EQ(daemon.log().find("does not read"), std::string::npos) << daemon.log();
  client.send(many_requests());
  EXPECT_TRUE(daemon.logs("does not read"));
}

class Reads : public Flow {};

TEST_P(Reads, RequestsThatFillItsBufferExactlyOrNearly) {
  const std::size_t buffer = GetParam() ? 2 * 1024 : 16 * 1024;
  const TimeoutHome home(10);
  DaemonProcess daemon(home);
  RawClient client(daemon.port());
  for (const std::size_t size : {buffer - 1, buffer, buffer + 1, 2 * buffer}) {
    std::string lines = line("first", "ping") + line("last", "ping");
    lines.insert(lines.size() - 1, std::string(size - lines.size(), ' '));
    ASSERT_EQ(lines.size(), size);
    ASSERT_TRUE(client.send(lines));
    EXPECT_EQ(client.response()["id"], "first") << size;
    EXPECT_EQ(client.response()["id"], "last") << size;
  }
}

/// Number of operations that a process has passed to io_uring; 0 without it. Source: the kernel's
/// io_uring/fdinfo.c.
long ring_operations(pid_t pid) {
  namespace fs = std::filesystem;
  const fs::path process = "/proc/" + std::to_string(pid);
  for (const fs::directory_entry& descriptor : fs::directory_iterator(process / "fd")) {
    std::error_code gone;
    if (fs::read_symlink(descriptor.path(), gone) != "anon_inode:[io_uring]") continue;
    std::ifstream info(process / "fdinfo" / descriptor.path().filename());
    for (std::string name; info >> name;)
      if (long count = 0; name == "SqTail:" && info >> count) return count;
  }
  return 0;
}

TEST_P(Reads, FromSocketsOfTheConfiguredKind) {
  const TimeoutHome home(10);
  DaemonProcess daemon(home);
  RawClient tcp(daemon.port());
  tcp.call("ping");
  const long after_tcp = ring_operations(daemon.pid());
  EXPECT_EQ(after_tcp > 0, GetParam());
  RawClient unix_socket(daemon.socket());
  unix_socket.call("ping");
  EXPECT_EQ(ring_operations(daemon.pid()) > after_tcp, GetParam());
}

/// The end of a test's name: "Ring" or "Plain".
std::string sockets(const testing::TestParamInfo<bool>& info) {
  return info.param ? "Ring" : "Plain";
}

INSTANTIATE_TEST_SUITE_P(Sockets, HeldBack, testing::Bool(), sockets);
INSTANTIATE_TEST_SUITE_P(Sockets, ReadSlowly, testing::Bool(), sockets);
INSTANTIATE_TEST_SUITE_P(Sockets, Reads, testing::Bool(), sockets);

}  // namespace
}  // namespace hedgehog::e2e
