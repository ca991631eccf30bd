// SPDX-License-Identifier: MIT
// The driver board on a real USB stack: detected, driven, unplugged, recovered.
#include <algorithm>
#include <string>

#include "tests/vm/bench.h"

namespace hedgehog::vm {
namespace {

using testing::AllOf;
using testing::Ge;
using testing::Le;

// daemon/safety.md: safe 100 ms after the last set-point, without current 5 L/R later.
constexpr int kDeadManMs = 100;
constexpr int kZeroMs = kDeadManMs + 17;

class Board : public Bench {
 protected:
  Board()
      : Bench({"board,unplugged", "board,name=other,serial=B2,unplugged", "stranger,unplugged"}) {}

  /// Starts a daemon with the board, and arms it.
  void begin() {
    configure();
    daemon_.emplace(home_);
    emulator_->ok("plug board");
    ASSERT_TRUE(daemon_->is("disarmed")) << daemon_->status();
    daemon_->arm();
  }
  /// Drives 15 A upwards, for longer than any test.
  void drive() {
    const Json admitted = daemon_->call(
        "effect.pulse", {{"direction", "up"}, {"current_a", 15}, {"duration_ms", 10'000}});
    ASSERT_TRUE(admitted.value("accepted", false)) << admitted;
    ASSERT_TRUE(eventually([&] { return emulator_->current_a() > 14.5; }));
  }
  /// Expects that the board made itself safe by its own clock.
  void expect_dead_man(const std::string& after) {
    ASSERT_TRUE(eventually([&] { return emulator_->status("board")["mode"] == "latched"; }));
    ASSERT_TRUE(eventually([&] { return emulator_->current_a() < 0.1; }));
    const Json zero = emulator_->last("zero");
    EXPECT_THAT(zero["set_point_age_ms"].get<int>(), AllOf(Ge(kDeadManMs), Le(kZeroMs)));
    EXPECT_EQ(zero["awake"], false);
    figure("zero at the board after " + after, zero["set_point_age_ms"], "ms of the board");
  }
  void expect_plays() {
    daemon_->arm();
    EXPECT_THAT(undisturbed_peak_a(5.0), AllOf(Ge(4.8), Le(5.3)));
  }
  /// The smallest of a few pulses' peaks: when a set-point arrives late, the voltage of an edge
  /// lasts longer.
  double undisturbed_peak_a(double current_a) {
    double min_a = daemon_->pulse(*emulator_, current_a, 200);
    for (int further = 4; further > 0 && min_a > 1.04 * current_a; --further)
      min_a = std::min(min_a, daemon_->pulse(*emulator_, current_a, 200));
    return min_a;
  }

  std::optional<Daemon> daemon_;
};

TEST_F(Board, IsFoundAndExchangesAThousandFramesASecondAndPlays) {
  configure();
  daemon_.emplace(home_);
  const Json absent = daemon_->status();
  EXPECT_EQ(absent["state"], "absent");
  EXPECT_EQ(absent["reason"], "no_board");
  EXPECT_TRUE(absent["temperature_c"]["sensor"].is_null());
  EXPECT_EQ(daemon_->call("effect.pulse", {{"direction", "up"}})["data"]["name"], "device_absent");

  const double plugged_ms = now_ms();
  emulator_->ok("plug board");
  ASSERT_TRUE(daemon_->is("disarmed")) << daemon_->status();
  figure("plug to ready, the first time", now_ms() - plugged_ms, "ms");
  const Json board = daemon_->call("device.describe")["board"];
  EXPECT_EQ(board["backend"], "usb");
  EXPECT_EQ(board["serial"], "B1");
  EXPECT_TRUE(board["firmware"].is_string()) << board;
  daemon_->arm();

  // The board's counts are read between two readings of the daemon's.
  const Json first = daemon_->status();
  const Json board_before = emulator_->status("board");
  const Json before = daemon_->status();
  pause_ms(2000);
  const Json after = daemon_->status();
  const Json board_after = emulator_->status("board");
  const Json last = daemon_->status();
  const auto more = [](const Json& a, const Json& b, const char* what) {
    return b[what].get<double>() - a[what].get<double>();
  };
  const double ticks = more(before["loop"], after["loop"], "ticks");
  const double out = more(before["link"], after["link"], "frames_out");
  const double lost = more(before["link"], after["link"], "lost");
  EXPECT_GT(ticks, 1900);
  EXPECT_GT(out, 0.97 * ticks);
  EXPECT_LE(lost, 0.01 * ticks);
  EXPECT_EQ(more(before["link"], after["link"], "errors"), 0);
  const double arrived = more(board_before, board_after, "frames_in");
  EXPECT_GE(arrived, out - 25) << "all of them arrive, but for those under way";
  EXPECT_LE(arrived, more(first["link"], last["link"], "frames_out") + 25);
  figure("frames to the board in 2 s", out, "");
  figure("of as many from it, lost", lost, "");
  figure("ticks of control skipped meanwhile", more(before["loop"], after["loop"], "skipped"), "");

  EXPECT_THAT(undisturbed_peak_a(5.0), AllOf(Ge(4.8), Le(5.3)));
  EXPECT_THAT(undisturbed_peak_a(15.0), AllOf(Ge(14.5), Le(15.6)));

  daemon_->call("telemetry.subscribe", {{"rate_hz", 50}});
  double last_ns = 0.0;
  for (int i = 0; i < 10; ++i) {
    const Json telemetry = daemon_->client().notification("telemetry");
    EXPECT_GT(telemetry["time_ns"].get<double>(), last_ns);
    EXPECT_NEAR(telemetry["temperature_c"]["sensor"].get<double>(), 30.0, 8.0);
    last_ns = telemetry["time_ns"];
  }
}

TEST_F(Board, UnpluggedWhileFifteenAmperesFlowIsSafeAndReturnsWhenPlugged) {
  begin();
  for (const std::string how : {"unplug", "cut"}) {
    drive();
    daemon_->call("events.subscribe");
    const double pulled_ms = now_ms();
    emulator_->ok(how + " board");
    const Json absent = daemon_->client().notification("event", "state_changed");
    EXPECT_EQ(absent["state"], "absent");
    figure(how + " to state absent", now_ms() - pulled_ms, "ms");
    expect_dead_man(how + " at 15 A");

    const double plugged_ms = now_ms();
    ASSERT_TRUE(eventually([&] { return emulator_->execute("plug board") == "ok"; }));
    const Json back = daemon_->client().notification("event", "state_changed");
    EXPECT_EQ(back["state"], "disarmed");
    figure("plug to ready", now_ms() - plugged_ms, "ms");
    EXPECT_EQ(emulator_->current_a(), 0.0) << "nothing plays on by itself";
    expect_plays();
  }
}

TEST_F(Board, BecomesSafeWhenTheDaemonIsKilledAndANewOneStartsDisarmed) {
  begin();
  drive();
  EXPECT_EQ(daemon_->stop(SIGKILL), -1);
  expect_dead_man("SIGKILL of the daemon at 15 A");
  daemon_.emplace(home_);
  ASSERT_TRUE(daemon_->is("disarmed")) << daemon_->status();
  expect_plays();
}

TEST_F(Board, IsSafeAtOnceWhenTheDaemonIsStopped) {
  begin();
  drive();
  EXPECT_EQ(daemon_->stop(SIGTERM), 0);
  EXPECT_LT(emulator_->current_a(), 0.1);
  EXPECT_LT(emulator_->last("zero")["set_point_age_ms"].get<int>(), kDeadManMs);
}

TEST_F(Board, RecoversAfterStalls) {
  begin();
  for (const std::string endpoint : {"81", "1"}) {
    const double stalled_ms = now_ms();
    emulator_->ok("stall board " + endpoint);
    const auto frames = [&] { return emulator_->status("board")["frames_in"].get<int>(); };
    const int before = frames();
    ASSERT_TRUE(eventually([&] { return frames() > before + 50; })) << daemon_->log();
    ASSERT_TRUE(eventually([&] {
      return daemon_->state() != "absent" && daemon_->status()["temperature_c"]["age_ms"] < 50;
    }));
    figure("stall of endpoint " + endpoint + " to 50 frames after it", now_ms() - stalled_ms, "ms");
    expect_plays();
  }
}

TEST_F(Board, ThatFallsSilentIsAbsentAndReturns) {
  begin();
  drive();
  emulator_->ok("silence board on");
  ASSERT_TRUE(daemon_->is("absent"));
  expect_dead_man("silence of both at 15 A");
  emulator_->ok("silence board off");
  ASSERT_TRUE(daemon_->is("disarmed"));
  expect_plays();
}

TEST_F(Board, OfAnotherVersionOrKindOrBesideASecondOneIsNamed) {
  configure();
  daemon_.emplace(home_);
  const auto expect_remedy = [&](const std::string& text) {
    EXPECT_TRUE(eventually([&] {
      return daemon_->status()["remedy"].dump().find(text) != std::string::npos;
    })) << text
        << "\n"
        << daemon_->status()["remedy"] << "\n"
        << daemon_->log();
  };
  emulator_->ok("plug stranger");
  expect_remedy("no interface of a driver board");
  emulator_->ok("unplug stranger");

  emulator_->ok("version board 2");
  emulator_->ok("plug board");
  expect_remedy("version 2 of the board protocol");
  EXPECT_EQ(daemon_->state(), "absent");
  emulator_->ok("unplug board");
  emulator_->ok("version board 1");

  emulator_->ok("plug board");
  emulator_->ok("plug other");
  EXPECT_TRUE(daemon_->stop() == 0);
  daemon_.emplace(home_);
  expect_remedy("two driver boards are connected");
  expect_remedy("B1");
  expect_remedy("B2");
  EXPECT_EQ(daemon_->stop(), 0);

  configure({{"device", "second"}});
  home_.write("config/hedgehog/devices.d/second.json", R"({"name": "second", "usb_serial": "B2"})");
  daemon_.emplace(home_);
  EXPECT_TRUE(eventually([&] { return daemon_->state() != "absent"; })) << daemon_->log();
  EXPECT_GT(emulator_->status("other")["frames_in"], 0);
}

// The remaining load is control's tick of 1 ms, the link's of 10 ms, and a scan for a board once a
// second.
TEST_F(Board, LeavesNoBusyLoop) {
  begin();
  const double with = daemon_->cpu_ms();
  pause_ms(3000);
  const double played = daemon_->cpu_ms();
  emulator_->ok("unplug board");
  ASSERT_TRUE(daemon_->is("absent"));
  pause_ms(2000);
  const double from = daemon_->cpu_ms();
  pause_ms(3000);
  const double share = (daemon_->cpu_ms() - from) / 30.0;
  figure("CPU of the daemon with a board at rest", (played - with) / 30.0, "%");
  figure("CPU of the daemon after unplugging", share, "%");
  EXPECT_LT(share, 2.0);
}

}  // namespace
}  // namespace hedgehog::vm
