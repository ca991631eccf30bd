// SPDX-License-Identifier: MIT
// How the daemon starts, listens, reloads and ends, and which state it persists.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <memory>
#include <string>

#include "tests/e2e/busy_machine.h"
#include "tests/e2e/daemon_process.h"
#include "tests/e2e/exit_codes.h"
#include "tests/e2e/program.h"
#include "tests/e2e/raw_client.h"
#include "tests/e2e/web_client.h"

namespace hedgehog::e2e {
namespace {

TEST(Start, LogsThatItSimulatesAndWhereItListens) {
  const Home home;
  DaemonProcess daemon(home, {}, {}, DaemonProcess::Backend::kFree);
  EXPECT_NE(daemon.log().find("SIMULATOR"), std::string::npos);
  struct stat s {};
  ASSERT_EQ(::stat(daemon.socket().c_str(), &s), 0);
  EXPECT_TRUE(S_ISSOCK(s.st_mode));
  EXPECT_EQ(s.st_mode & 0777, 0660u);
  RawClient unix_client(daemon.socket());
  EXPECT_EQ(unix_client.call("hello")["role"], "operate");
  EXPECT_EQ(unix_client.call("device.status")["simulated"], true);
  EXPECT_TRUE(arms(unix_client));
  EXPECT_EQ(daemon.stop(), 0);
  EXPECT_NE(::stat(daemon.socket().c_str(), &s), 0);
}

TEST(Start, TheFirstClientFindsAnArmedBallAndTheLogHasNoWarning) {
  const Home home;
  const DaemonProcess daemon(home);
  EXPECT_EQ(daemon.log().find("never_armed"), std::string::npos) << "it arms itself at once";
  EXPECT_EQ(RawClient(daemon.port()).call("device.status")["state"], "armed");
}

TEST(Start, AStaleSocketIsReplacedAndOneInUseIsNot) {
  const Home home;
  DaemonProcess killed(home);
  EXPECT_EQ(killed.stop(SIGKILL), -1);
  DaemonProcess daemon(home);
  const Ended second = run_daemon(home, {"--simulate", "--listen", "127.0.0.1:0"});
  EXPECT_EQ(second.exit_code, kCannotCreate);
  EXPECT_NE(second.err.find("another hedgehogd is running"), std::string::npos);
  EXPECT_TRUE(RawClient(daemon.socket()).call("ping").contains("time_ns"));
}

TEST(Start, RemotelyReachableAddressesAreRefused) {
  const Home home;
  const Ended ended = run_daemon(home, {"--simulate", "--listen", "0.0.0.0:0"});
  EXPECT_EQ(ended.exit_code, kConfig);
  EXPECT_NE(ended.err.find("other machines could reach"), std::string::npos) << ended.err;
}

TEST(Start, ErrorsHaveTheirExitCodes) {
  const Home home;
  EXPECT_EQ(run_daemon(home, {"--nonsense"}).exit_code, kUsage);
  EXPECT_EQ(run_daemon(home, {"--speed", "10"}).exit_code, kUsage);
  EXPECT_EQ(run_daemon(home, {"--simulate", "--speed", "1000"}).exit_code, kUsage);
  EXPECT_EQ(run_daemon(home, {"--simulate", "--step-ms", "10"}).exit_code, kUsage);
  const Ended far = run_daemon(home, {"--simulate", "--speed", "40", "--step-ms", "3"});
  EXPECT_EQ(far.exit_code, kUsage);
  EXPECT_NE(far.err.find("--step-ms: 3 with --speed 40, at most 2"), std::string::npos) << far.err;
  EXPECT_EQ(run_daemon(home, {"--check-config"}).exit_code, 0);
  EXPECT_EQ(run_daemon(home, {"--replay", "/no/such/file"}).exit_code, 66);
  const Ended version = run_daemon(home, {"--version"});
  EXPECT_EQ(version.exit_code, 0);
  EXPECT_NE(version.out.find("hedgehogd"), std::string::npos);
  const Ended printed = run_daemon(home, {"--print-config"});
  EXPECT_TRUE(Json::parse(printed.out, nullptr, true, true).contains("limits"));
  home.configure("{\n  \"limits\": {\"curent_a\": 3}\n}\n");
  const Ended wrong = run_daemon(home, {"--check-config"});
  EXPECT_EQ(wrong.exit_code, kConfig);
  EXPECT_NE(wrong.err.find("hedgehogd.json:2: limits.curent_a"), std::string::npos) << wrong.err;
}

// Ids that no device has, so that a ball connected to the developer's machine is not used.
TEST(Start, WithoutABoardItWaitsForOne) {
  const Home home;
  home.configure(R"({"backend": "usb", "device": "none"})");
  home.write("config/hedgehog/devices.d/none.json", R"({"name": "none", "usb": ["0000:0000"]})");
  DaemonProcess daemon(home, {}, {}, DaemonProcess::Backend::kConfigured);
  RawClient game(daemon.port());
  const Json status = game.call("device.status");
  EXPECT_EQ(status["state"], "absent");
  EXPECT_EQ(status["reason"], "no_board");
  EXPECT_EQ(status["simulated"], false);
  EXPECT_TRUE(status["temperature_c"]["sensor"].is_null());
  EXPECT_TRUE(status["temperature_c"]["model"].is_null()) << "nothing has measured it";
  const Json refused = game.call("effect.pulse", {{"direction", "left"}});
  EXPECT_EQ(refused["data"]["name"], "device_absent");
  EXPECT_EQ(refused["data"]["device"], "board");
  EXPECT_TRUE(daemon.logs("board: no driver board is connected (0000:0000)"));

  EXPECT_EQ(game.call("hello")["role"], "play");
  EXPECT_EQ(WebSocketClient(daemon.http_port()).call("hello")["role"], "play");
  EXPECT_EQ(RawClient(daemon.socket()).call("hello")["role"], "operate");
  const Json forbidden = game.call("device.arm");
  EXPECT_EQ(forbidden["code"], -32004);
  EXPECT_EQ(forbidden["data"]["name"], "forbidden");
  EXPECT_EQ(daemon.stop(), 0);
  EXPECT_TRUE(daemon.logs("no ball is connected"));
}

/// Outcome for a daemon that receives SIGTERM while its ball pushes.
struct Sigterm {
  bool pushed = false;     // until the signal; a busy machine may lose the ball before
  bool coils_off = false;  // confirmed by the board
};

Sigterm sigterm(DaemonProcess::Backend backend) {
  const Home home;
  DaemonProcess daemon(home, {}, {}, backend);
  RawClient game(daemon.port());
  game.call("events.subscribe", {{"types", {"effect_started", "effect_ended", "shutting_down"}}});
  const Json held = game.call("effect.hold", {{"direction", "up"}, {"lease_ms", 10000}});
  if (!held.contains("effect") || game.notification("event", "effect_started").empty()) return {};
  EXPECT_EQ(daemon.stop(SIGTERM), 0);
  if (game.notification("event", "effect_ended")["reason"] != "stopped") return {};
  EXPECT_EQ(game.notification("event", "shutting_down")["reason"], "stop");
  EXPECT_TRUE(game.closed_by_daemon());
  EXPECT_EQ(Json::parse(home.read("state/hedgehog/state.json"))["clean_stop"], true);
  return {true, daemon.log().find("coils off") != std::string::npos};
}

TEST(End, SigtermMakesTheCoilsSafeNotifiesClientsAndExitsWith0) {
  const Sigterm end = sigterm(DaemonProcess::Backend::kInStep);
  EXPECT_TRUE(end.pushed);
  EXPECT_TRUE(end.coils_off);
}

TEST(End, SigtermMakesTheCoilsOfABallWithThreadsOfItsOwnSafe) {
  Sigterm end;
  ASSERT_TRUE(eventually([&] {
    end = sigterm(DaemonProcess::Backend::kFree);
    return end.pushed;
  }));
  EXPECT_TRUE(end.coils_off);
}

TEST(End, SigintIsAnOrderlyStopToo) {
  const Home home;
  DaemonProcess daemon(home, {}, {}, DaemonProcess::Backend::kFree);
  EXPECT_EQ(daemon.stop(SIGINT), 0);
}

TEST(Reload, AppliesNewLimitsAndKeepsTheOldOnesWhenTheFileIsInvalid) {
  const Home home;
  home.configure("{}");
  DaemonProcess daemon(home);
  RawClient game(daemon.port());
  EXPECT_EQ(game.call("hello")["limits"]["current_a"], 15);
  const Json start_id = game.call("hello")["start_id"];
  home.configure(R"({"limits": {"current_a": 8}})");
  daemon.signal(SIGHUP);
  EXPECT_TRUE(daemon.logs("configuration reloaded"));
  EXPECT_EQ(game.call("hello")["start_id"], start_id) << "a reload is no start";
  EXPECT_EQ(game.call("hello")["limits"]["current_a"], 8);
  game.call("effect.pulse", {{"direction", "up"}});
  EXPECT_EQ(game.call("effect.pulse", {{"direction", "up"}, {"current_a", 9}})["code"], -32602);
  EXPECT_TRUE(eventually([&] { return game.call("device.status")["limit_a"] == 8; }));
  home.configure(R"({"arm_at_start": "never", "connections": {"max": 7}})");
  daemon.signal(SIGHUP);
  EXPECT_TRUE(daemon.logs("at the next start only: arm_at_start, limits.current_a\n"));
  EXPECT_EQ(game.call("hello")["limits"]["current_a"], 8) << "the board keeps its tighter limits";
  home.configure(R"({"limits": {"current_a": "much"}})");
  daemon.signal(SIGHUP);
  EXPECT_TRUE(daemon.logs("the old one remains in effect"));
  EXPECT_EQ(game.call("hello")["limits"]["current_a"], 8);
}

TEST(StateStore, AnEmergencyStopPersistsOverAKill) {
  const Home home;
  {
    DaemonProcess daemon(home, {}, {}, DaemonProcess::Backend::kFree);
    RawClient owner(daemon.port());
    // The field is absent while the ball is lost on a busy machine.
    EXPECT_TRUE(
        eventually([&] { return owner.call("device.emergency_stop")["state"] == "disarmed"; }));
    daemon.stop(SIGKILL);
    EXPECT_NE(home.read("state/hedgehog/state.json").find("emergency_stop"), std::string::npos)
        << "the answer waits for the disk";
  }
  {
    DaemonProcess daemon(home);
    RawClient owner(daemon.port());
    const Json hello = owner.call("hello");
    EXPECT_EQ(hello["state"], "disarmed");
    EXPECT_EQ(hello["reason"], "emergency_stop");
    EXPECT_NE(hello["remedy"].get<std::string>().find("hedgehogctl arm"), std::string::npos);
    EXPECT_EQ(daemon.stop(), 0);  // an orderly stop does not clear it
  }
  DaemonProcess daemon(home);
  RawClient owner(daemon.port());
  EXPECT_EQ(owner.call("hello")["reason"], "emergency_stop");
  EXPECT_EQ(owner.call("device.arm")["state"], "armed");
  EXPECT_EQ(daemon.stop(), 0);
  DaemonProcess again(home);
  EXPECT_EQ(RawClient(again.port()).call("hello")["state"], "armed");
}

TEST(StateStore, AnUnpersistedEmergencyStopIsReportedAndTheStopIsNotOrderly) {
  const Home home;
  DaemonProcess(home).stop();
  ASSERT_EQ(Json::parse(home.read("state/hedgehog/state.json"))["clean_stop"], true);
  home.write("state/hedgehog/state.json.new/in-the-way", "");
  DaemonProcess daemon(home);
  EXPECT_TRUE(daemon.logs("state.json.new: Is a directory: the state was not saved"));
  const Json stopped = RawClient(daemon.port()).call("device.emergency_stop");
  EXPECT_EQ(stopped["state"], "disarmed");
  EXPECT_EQ(stopped["on_disk"], false);
  EXPECT_EQ(daemon.stop(), 0);
  EXPECT_TRUE(daemon.logs("; the next start is treated as one after a crash"));
  EXPECT_EQ(home.read("state/hedgehog/state.json"), "");
}

/// Trips the armed ball of a new daemon by an open sensor and kills the daemon. False if the ball
/// was lost before on a busy machine.
bool trips_by_an_open_sensor(const Home& home) {
  DaemonProcess daemon(home, {}, {}, DaemonProcess::Backend::kFree);
  RawClient owner(daemon.port());
  owner.call("events.subscribe");
  if (owner.call("device.status")["state"] != "armed") return false;
  owner.call("sim.set", {{"fault", {{"faults", {"sensor_open"}}}}});
  if (owner.notification("event", "state_changed")["reason"] != "sensor_open") return false;
  EXPECT_TRUE(daemon.logs("trip-0001.hhr"));
  daemon.stop(SIGKILL);
  return true;
}

TEST(StateStore, ATripIsRecordedReplayableAndPersistsOverARestart) {
  std::unique_ptr<Home> fresh;
  ASSERT_TRUE(eventually([&] {
    fresh = std::make_unique<Home>();
    return trips_by_an_open_sensor(*fresh);
  }));
  const Home& home = *fresh;
  EXPECT_EQ(run_daemon(home, {"--replay", home.path("state/hedgehog/trip-0001.hhr")}).exit_code, 0);
  const Ended none = run_daemon(home, {"--replay", "trip-0099"});
  EXPECT_EQ(none.exit_code, 66);
  EXPECT_NE(none.err.find(home.path("state/hedgehog/trip-0099.hhr: cannot be read")),
            std::string::npos)
      << none.err;
  const Ended replayed = run_daemon(home, {"--replay", "trip-0001"});
  EXPECT_EQ(replayed.exit_code, 0) << replayed.err;
  EXPECT_NE(replayed.out.find(R"("reason":"sensor_open")"), std::string::npos);
  EXPECT_NE(replayed.out.find(R"("different":0)"), std::string::npos);
  DaemonProcess daemon(home);
  const Json hello = RawClient(daemon.port()).call("hello");
  EXPECT_EQ(hello["state"], "tripped");
  EXPECT_EQ(hello["reason"], "sensor_open");
}

TEST(StateStore, AHotBallIsHotAfterARestart) {
  const Home home;
  {
    DaemonProcess daemon(home, {"--speed", "5"});
    RawClient game(daemon.port());
    game.call("telemetry.subscribe", {{"rate_hz", 10}, {"fields", {"temperature_c"}}});
    EXPECT_TRUE(eventually([&] {
      game.call("effect.hold",
                {{"direction", "left"}, {"current_a", 15}, {"lease_ms", 10000}, {"slot", "heat"}});
      return game.notification("telemetry")["temperature_c"]["model"] > 58.0;
    }));
    EXPECT_EQ(daemon.stop(), 0);
  }
  DaemonProcess daemon(home);
  const Json status = RawClient(daemon.port()).call("device.status");
  EXPECT_GT(status["temperature_c"]["model"].get<double>(), 40.0);
  daemon.stop();
  home.write("state/hedgehog/state.json", R"({"version":1,"winding_c":[1e9)");
  DaemonProcess damaged(home);
  EXPECT_TRUE(damaged.logs("state.json: damaged. Latch and temperature are unknown"));
  RawClient owner(damaged.port());
  EXPECT_EQ(owner.call("hello")["reason"], "state_lost");
  EXPECT_TRUE(eventually([&] { return owner.call("device.arm").value("state", "") == "armed"; }));
  const Json held = owner.call("effect.pulse", {{"direction", "left"}, {"current_a", 15}});
  EXPECT_EQ(held["limited_by"], "thermal");
  EXPECT_NEAR(held["current_a"].get<double>(), 5.0, 1e-6);
}

TEST(StateStore, TheGainPersistsOverARestart) {
  const Home home;
  {
    DaemonProcess daemon(home);
    EXPECT_EQ(RawClient(daemon.port()).call("output.set_gain", {{"gain", 0.5}})["gain"], 0.5);
    EXPECT_EQ(daemon.stop(), 0);
  }
  DaemonProcess daemon(home);
  EXPECT_EQ(RawClient(daemon.port()).call("device.describe")["gain"], 0.5);
}

}  // namespace
}  // namespace hedgehog::e2e
