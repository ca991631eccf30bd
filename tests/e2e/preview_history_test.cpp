// SPDX-License-Identifier: MIT
// effect.preview and events.history of a real daemon, and hedgehogctl's preview, trips and
// events --since.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "tests/e2e/daemon_process.h"
#include "tests/e2e/program.h"
#include "tests/e2e/programs.h"
#include "tests/e2e/raw_client.h"

namespace hedgehog::e2e {
namespace {

using ::testing::HasSubstr;

Ended ctl(const Home& home, const DaemonProcess& daemon,
          const std::vector<std::string>& arguments) {
  return Program(home, hedgehogctl(), arguments, {"HEDGEHOG_ADDRESS=" + daemon.socket()}).wait();
}

TEST(PreviewAndHistory, APreviewPlaysNothingAndPredictsTheMeasurement) {
  const Home home;
  DaemonProcess daemon(home);
  RawClient game(daemon.port());
  const Json params{{"direction", "left"}, {"current_a", 8}, {"duration_ms", 400}};
  const Json preview =
      game.call("effect.preview", {{"method", "effect.pulse"}, {"params", params}});
  EXPECT_EQ(preview["duration_ms"], 400);
  EXPECT_NEAR(preview["current_a"][50][1].get<double>(), 8.0, 0.1);

  game.call("telemetry.subscribe",
            {{"rate_hz", 100}, {"fields", {"current_a", "effects", "time_ns"}}});
  for (int i = 0; i < 10; ++i) {
    const Json telemetry = game.notification("telemetry");
    EXPECT_TRUE(telemetry["effects"].empty());
    EXPECT_LT(std::abs(telemetry["current_a"][1].get<double>()), 0.3);
  }
  RawClient player(daemon.port());
  player.call("events.subscribe");
  player.call("effect.pulse", params);
  const Json ended = player.notification("event", "effect_ended");
  double max_a = 0.0;
  for (double last_ns = 0.0; last_ns < ended["time_ns"];) {
    const Json telemetry = game.notification("telemetry");
    last_ns = telemetry["time_ns"];
    max_a = std::max(max_a, telemetry["current_a"][1].get<double>());
  }
  EXPECT_NEAR(max_a, preview["peak_current_a"].get<double>(), 0.3);

  const Ended shown = ctl(home, daemon, {"preview", "pulse", "left", "--current-a", "8"});
  EXPECT_EQ(shown.exit_code, 0) << shown.err;
  EXPECT_THAT(shown.out, HasSubstr("pulse left, 150 ms, if it were started now"));
  EXPECT_THAT(shown.out, HasSubstr("limited by   nothing"));
  EXPECT_EQ(ctl(home, daemon, {"preview", "play", "heartbeat", "left"}).exit_code, 0);
  EXPECT_EQ(ctl(home, daemon, {"preview", "pulse", "left", "--level", "3"}).exit_code, 64);
  EXPECT_EQ(ctl(home, daemon, {"preview"}).exit_code, 64);
}

TEST(PreviewAndHistory, APendingPreviewIsSentBeforeTheDaemonEnds) {
  const Home home;
  DaemonProcess daemon(home);
  RawClient game(daemon.port());
  game.send(R"({"jsonrpc":"2.0","id":"later","method":"effect.preview","params":)"
            R"({"method":"effect.circle","params":{"duration_ms":3000}}})"
            "\n"
            R"({"jsonrpc":"2.0","id":"now","method":"ping"})"
            "\n");
  EXPECT_EQ(game.response()["id"], "now");
  EXPECT_EQ(daemon.stop(), 0);
  EXPECT_EQ(game.response()["result"]["duration_ms"], 3000);
}

TEST(PreviewAndHistory, ATripPersistsOverAKillAndARestartIsNone) {
  const Home home;
  {
    DaemonProcess daemon(home);
    EXPECT_THAT(ctl(home, daemon, {"trips"}).out, HasSubstr("no trips"));
    RawClient game(daemon.port());
    game.call("hello", {{"client", "Racer/1.2"}});
    game.call("events.subscribe");
    game.call("effect.hold", {{"direction", "left"}, {"lease_ms", 9000}});
    game.notification("event", "effect_started");
    game.call("sim.set", {{"fault", {{"faults", {"sensor_open"}}}}});
    EXPECT_EQ(game.notification("event", "state_changed")["reason"], "sensor_open");
    ASSERT_TRUE(eventually([&] {
      return home.read("state/hedgehog/trips.jsonl").find("sensor_open") != std::string::npos;
    }));
    daemon.logs("trip-0001.hhr");
    daemon.stop(SIGKILL);
  }
  DaemonProcess daemon(home);
  RawClient game(daemon.port());
  EXPECT_EQ(game.call("hello")["state"], "tripped");
  const Ended trips = ctl(home, daemon, {"trips"});
  EXPECT_EQ(trips.exit_code, 0) << trips.err;
  EXPECT_THAT(trips.out, HasSubstr("sensor_open"));
  EXPECT_THAT(trips.out, HasSubstr("A  Racer/1.2    trip-0001\n"));
  const Json response = Json::parse(ctl(home, daemon, {"--json", "trips"}).out);
  ASSERT_EQ(response["events"].size(), 1u) << "that it is still tripped is no new trip";
  EXPECT_EQ(response["events"][0]["method"], "effect.hold");
  const Ended events = ctl(home, daemon, {"events", "--since", "1h", "--types", "state_changed"});
  EXPECT_EQ(events.exit_code, 0) << events.err;
  EXPECT_THAT(events.out, HasSubstr("state_changed  tripped: sensor_open"));
  EXPECT_EQ(ctl(home, daemon, {"events", "--since", "once"}).exit_code, 64);
  EXPECT_EQ(daemon.stop(), 0);
  EXPECT_THAT(home.read("state/hedgehog/events.jsonl"), HasSubstr("shutting_down"));
  EXPECT_EQ(home.read("state/hedgehog/trip-0002.hhr"), "") << "nor is it recorded";
}

}  // namespace
}  // namespace hedgehog::e2e
