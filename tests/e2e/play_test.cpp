// SPDX-License-Identifier: MIT
// The daemon used by client processes: the protocol document's examples, clients that disconnect,
// clients that only pipe, and a daemon that is stopped or killed while it drives a board in a
// process of its own.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "tests/e2e/busy_machine.h"
#include "tests/e2e/daemon_process.h"
#include "tests/e2e/program.h"
#include "tests/e2e/raw_client.h"
#include "tests/folders.h"
#include "tests/protocol/example_file.h"

namespace hedgehog::e2e {
namespace {

/// Replays one block of protocol/README.md; returns the first difference, or an empty string.
std::string replay(const protocol::Example& example, RawClient& client) {
  for (const protocol::ExampleLine& line : example.lines) {
    const std::string where = "protocol/README.md:" + std::to_string(line.number) + ": ";
    if (line.sent) {
      client.send(line.text + "\n");
      continue;
    }
    constexpr int kMaxOthers = 200;
    for (int others = 0;; ++others) {
      if (others == kMaxOthers)
        return where + "it did not come among " + std::to_string(others) + " notifications";
      const auto got = client.line();
      if (!got) return where + "the daemon closed";
      const std::string difference = protocol::mismatch(line.text, *got);
      if (difference.empty()) break;
      const Json message = Json::parse(*got);
      if (message.is_array() || !message.contains("method"))
        return where + difference + "\n  got " + *got;
    }
  }
  return {};
}

TEST(Play, TheExamplesOfTheProtocolHold) {
  const auto examples = protocol::protocol_examples(source_folder());
  ASSERT_GE(examples.size(), 20u);
  for (const protocol::Example& example : examples) {
    const Home home;
    DaemonProcess daemon(home);
    RawClient client(daemon.port());
    EXPECT_EQ(replay(example, client), "");
  }
}

/// Sends a pulse that may finish through a pipe; returns the reason of its end, or the error.
Json end_of_piped_pulse(const DaemonProcess& daemon, RawClient& watcher) {
  RawClient pipe(daemon.port());
  pipe.send(R"({"jsonrpc":"2.0","id":1,"method":"effect.pulse",)"
            R"("params":{"direction":"left","on_close":"finish"}})"
            "\n");
  pipe.half_close();
  const Json response = pipe.response();
  EXPECT_TRUE(pipe.closed_by_daemon());
  if (!response.contains("result")) return response;
  EXPECT_EQ(response["result"]["accepted"], true);
  return watcher.notification("event")["reason"];
}

/// Starts a long pulse and disconnects; returns the reason of its end, or the error.
Json end_of_disconnected_pulse(const DaemonProcess& daemon, RawClient& watcher) {
  RawClient other(daemon.port());
  const Json response = other.call("effect.pulse", {{"direction", "left"}, {"duration_ms", 5000}});
  if (!response.contains("effect")) return response;
  other.half_close();
  return watcher.notification("event")["reason"];
}

TEST(Play, APulseThroughAPipePlays) {
  const Home home;
  const DaemonProcess daemon(home);
  RawClient watcher(daemon.port());
  watcher.call("events.subscribe", {{"scope", "all"}, {"types", {"effect_ended"}}});
  EXPECT_EQ(end_of_piped_pulse(daemon, watcher), "completed");
  EXPECT_EQ(end_of_disconnected_pulse(daemon, watcher), "disconnected");
}

TEST(Play, APulseThroughAPipePlaysOnABallWithThreadsOfItsOwn) {
  const Home home;
  const DaemonProcess daemon(home, {}, {}, DaemonProcess::Backend::kFree);
  RawClient watcher(daemon.port());
  watcher.call("events.subscribe", {{"scope", "all"}, {"types", {"effect_ended"}}});
  EXPECT_TRUE(eventually(
      [&] { return arms(watcher) && end_of_piped_pulse(daemon, watcher) == "completed"; }));
  EXPECT_TRUE(eventually([&] {
    return arms(watcher) && end_of_disconnected_pulse(daemon, watcher) == "disconnected";
  }));
}

TEST(Play, TheEffectsOfADisconnectedClientEnd) {
  const Home home;
  DaemonProcess daemon(home);
  RawClient watcher(daemon.socket());
  watcher.call("events.subscribe", {{"scope", "all"}});
  const Json own = watcher.call("effect.hold", {{"direction", "up"}, {"lease_ms", 10000}});
  watcher.notification("event", "effect_started");
  {
    RawClient game(daemon.port());
    game.call("hello", {{"client", "Racer/1.2"}});
    game.call("effect.hold", {{"direction", "left"}, {"lease_ms", 10000}});
    EXPECT_EQ(watcher.call("connection.list")["connections"][1]["client"], "Racer/1.2");
  }
  const Json ended = watcher.notification("event", "effect_ended");
  EXPECT_EQ(ended["reason"], "disconnected");
  const Json status = watcher.call("device.status");
  ASSERT_EQ(status["effects"].size(), 1u);
  EXPECT_EQ(status["effects"][0]["effect"], own["effect"]);
}

TEST(Play, ACircleStepsTenTimesASecond) {
  const Home home;
  DaemonProcess daemon(home, {"--speed", "10"});
  RawClient game(daemon.port());
  game.call("events.subscribe");
  const Json circle = game.call("effect.circle", {{"duration_ms", 3000}});
  EXPECT_EQ(circle["period_ms"], 1500);
  const Json ended = game.notification("event", "effect_ended");
  EXPECT_EQ(ended["reason"], "completed");
  EXPECT_EQ(ended["offset_ns"].get<std::int64_t>() - ended["onset_ns"].get<std::int64_t>(),
            3'000'000'000);
}

TEST(Play, MoreClientsThanAllowedAreRefusedWithASentence) {
  const Home home;
  home.configure(R"({"connections": {"max": 2}})");
  DaemonProcess daemon(home);
  RawClient first(daemon.port());
  RawClient second(daemon.port());
  first.call("ping");
  second.call("ping");
  RawClient third(daemon.port());
  EXPECT_EQ(third.response()["error"]["code"], -32001);
  EXPECT_TRUE(third.closed_by_daemon());
  second.close();
  ASSERT_TRUE(eventually([&] { return first.call("connection.list")["connections"].size() == 1; }));
  RawClient fourth(daemon.port());
  fourth.call("ping");
}

/// The trace of the board process, one object a line; without a line that is still being written.
std::vector<Json> trace(const Home& home) {
  std::vector<Json> lines;
  std::istringstream text(home.read("trace"));
  for (std::string line; std::getline(text, line);) {
    Json parsed = Json::parse(line, nullptr, false);
    if (!parsed.is_discarded()) lines.push_back(std::move(parsed));
  }
  return lines;
}

/// True if the board has latched since it last drove, and its current has then decayed.
bool is_at_rest(const Home& home) {
  const std::vector<Json> lines = trace(home);
  const auto drove = std::find_if(lines.rbegin(), lines.rend(),
                                  [](const Json& line) { return line["mode"] == "driving"; });
  if (drove == lines.rend()) return false;
  const auto latched = std::find_if(
      drove.base(), lines.end(), [](const Json& line) { return line["mode"] == "latched"; });
  return std::any_of(latched, lines.end(),
                     [](const Json& line) { return line["event"] == "zero"; });
}

/// 5 L/R of a winding, and one frame: after this time no current flows.
constexpr int kDecayMs = 18;

/// Checks by the board's own trace how it became safe.
void expect_safe_after_dead_man(const Home& home) {
  EXPECT_TRUE(eventually([&] { return is_at_rest(home); })) << home.read("trace");
  bool drove = false;
  std::optional<int> latched_ms;
  std::optional<int> zero_ms;
  for (const Json& line : trace(home)) {
    drove = drove || line["mode"] == "driving";
    if (line["mode"] == "driving") {  // armed anew: it had latched before on a busy machine
      latched_ms.reset();
      zero_ms.reset();
    }
    if (line["mode"] == "latched" && !latched_ms) {
      latched_ms = line["board_ms"].get<int>();
      EXPECT_EQ(line["awake"], false) << line;
      EXPECT_EQ(line["duty"], 0) << line;
      // 100 ms by the board's own clock, and one frame.
      EXPECT_GE(line["set_point_age_ms"].get<int>(), 100) << line;
      EXPECT_LE(line["set_point_age_ms"].get<int>(), 101) << line;
    }
    if (line["event"] == "zero" && latched_ms) {
      zero_ms = line["board_ms"].get<int>();
      EXPECT_LT(line["current_a"].get<double>(), 0.1) << line;
    }
  }
  EXPECT_TRUE(drove) << home.read("trace");
  ASSERT_TRUE(latched_ms) << home.read("trace");
  ASSERT_TRUE(zero_ms) << home.read("trace");
  EXPECT_LE(*zero_ms - *latched_ms, kDecayMs);
}

class OwnBoard : public testing::Test {
 protected:
  OwnBoard() { home_.configure(R"({"simulator": {"process": true}})"); }
  void drive(RawClient& game) {
    game.call("events.subscribe");
    game.call("telemetry.subscribe", {{"rate_hz", 100}, {"fields", {"current_a"}}});
    Json held;
    // On a busy machine the ball, and with it the hold, may be lost.
    ASSERT_TRUE(eventually([&] {
      if (!arms(game)) return false;
      held = renew_hold(game, {{"direction", "left"}, {"current_a", 10}});
      return std::abs(game.notification("telemetry")["current_a"][1].get<double>()) >= 8.0;
    })) << held;
  }
  Home home_;
};

TEST_F(OwnBoard, IsSafe100MsAfterTheDaemonIsKilled) {
  DaemonProcess daemon(home_, {}, {}, DaemonProcess::Backend::kFree);
  RawClient game(daemon.port());
  ASSERT_NO_FATAL_FAILURE(drive(game));
  daemon.stop(SIGKILL);
  expect_safe_after_dead_man(home_);
}

TEST_F(OwnBoard, RunsInLockStepWithAScaledDaemonAndIsSafeWithoutIt) {
  DaemonProcess daemon(home_, {"--speed", "5"});
  RawClient game(daemon.port());
  ASSERT_NO_FATAL_FAILURE(drive(game));
  const Json status = game.call("device.status");
  EXPECT_EQ(status["loop"]["skipped"], 0);
  EXPECT_EQ(status["link"]["lost"], 0);
  daemon.stop(SIGKILL);
  expect_safe_after_dead_man(home_);
}

TEST_F(OwnBoard, IsSafe100MsAfterTheDaemonFreezesAndStaysSoUntilArmed) {
  DaemonProcess daemon(home_, {}, {}, DaemonProcess::Backend::kFree);
  RawClient game(daemon.port());
  ASSERT_NO_FATAL_FAILURE(drive(game));
  daemon.signal(SIGSTOP);
  expect_safe_after_dead_man(home_);
  daemon.signal(SIGCONT);
  game.call("telemetry.unsubscribe");
  const Json changed = game.notification("event", "state_changed");
  EXPECT_NE(changed["state"], "armed");
  EXPECT_NE(game.call("hello")["state"], "armed");
  // Once the board sends telemetry again and its windings are measured to be at rest, it can be
  // armed.
  EXPECT_TRUE(eventually([&] { return game.call("device.arm").value("state", "") == "armed"; }));
}

}  // namespace
}  // namespace hedgehog::e2e
