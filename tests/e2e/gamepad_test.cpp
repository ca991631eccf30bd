// SPDX-License-Identifier: MIT
// The gamepad bridge between a gamepad controlled by the test and a real daemon.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "clients/gamepad/bridge.h"
#include "model/quaternion.h"
#include "tests/e2e/daemon_process.h"
#include "tests/e2e/json_vector.h"
#include "tests/e2e/program.h"
#include "tests/e2e/programs.h"
#include "tests/e2e/raw_client.h"
#include "tests/e2e/timeout.h"
#include "tests/fake_gamepad.h"

namespace hedgehog::e2e {
namespace {

using gamepad::FakeGamepad;
using gamepad::StickPosition;

ff_effect push_right(int length_ms) {
  ff_effect effect{};
  effect.type = FF_CONSTANT;
  effect.direction = 0x4000;
  effect.u.constant.level = 0x7fff;
  effect.replay.length = static_cast<std::uint16_t>(length_ms);
  return effect;
}

class Gamepad : public testing::Test {
 protected:
  Gamepad() : daemon_(home_), ball_(daemon_.port()) {
    ball_.call("events.subscribe",
               {{"scope", "all"}, {"types", {"effect_started", "effect_ended"}}});
    gamepad::BridgeOptions options;
    options.addresses = {client::parse_address(daemon_.socket()).value()};
    options.trace = true;
    thread_ = std::thread([this, options] {
      gamepad::Bridge bridge(
          device_, options, [this](const std::string& line) { report(line); });
      (void)bridge.run([this] { return stop_.load(); });
    });
    EXPECT_TRUE(eventually([&] { return !reports().empty(); }));
  }
  ~Gamepad() override {
    stop_ = true;
    thread_.join();
  }
  void report(const std::string& line) {
    const std::lock_guard lock(mutex_);
    if (line.starts_with("game: "))
      trace_.push_back(line);
    else
      reports_.push_back(line);
  }
  std::vector<std::string> reports() const {
    const std::lock_guard lock(mutex_);
    return reports_;
  }
  std::vector<std::string> trace() const {
    const std::lock_guard lock(mutex_);
    return trace_;
  }
  int upload(const ff_effect& effect) {
    device_.command(gamepad::UploadRequest{1, effect});
    EXPECT_TRUE(eventually([&] { return device_.uploaded() >= 0; }));
    return device_.uploaded();
  }
  void turn(const model::Quaternion& q) { ball_.call("sim.set", {{"orientation", json_of(q)}}); }
  bool flows(const model::Vec3& direction) {
    return eventually([&] {
      const Json status = ball_.call("device.status");
      const auto field = vector_of(status["field"]);
      return dot(field, direction) > 0.99 && status["force_n"] > 0.0;
    });
  }

  const Home home_;
  DaemonProcess daemon_;
  RawClient ball_;
  FakeGamepad device_;
  std::atomic<bool> stop_ = false;
  mutable std::mutex mutex_;
  std::vector<std::string> trace_;
  std::vector<std::string> reports_;
  std::thread thread_;
};

TEST_F(Gamepad, AForceFromTheRightPushesTheRightSideAndEndsByItself) {
  EXPECT_EQ(upload(push_right(300)), 0);
  device_.command(gamepad::PlayCommand{0, 1});
  EXPECT_EQ(ball_.notification("event", "effect_started")["slot"], "ff0");
  const Json ended = ball_.notification("event", "effect_ended");
  EXPECT_EQ(ended["reason"], "completed");
  EXPECT_EQ(ended["offset_ns"].get<std::int64_t>() - ended["onset_ns"].get<std::int64_t>(),
            300'000'000);
}

TEST_F(Gamepad, OneWithoutAnEndPlaysUntilItIsErased) {
  EXPECT_EQ(upload(push_right(0)), 0);
  device_.command(gamepad::PlayCommand{0, 1});
  EXPECT_TRUE(flows({0, -1, 0}));
  // Longer than the effect's lease, which is in device time.
  const auto now = [&] { return ball_.call("ping")["time_ns"].get<std::int64_t>(); };
  const auto from = now();
  EXPECT_TRUE(eventually([&] { return now() - from > 1'500'000'000; }));
  EXPECT_EQ(ball_.call("device.status")["effects"].size(), 1u);
  device_.command(gamepad::EraseRequest{2, 0});
  EXPECT_EQ(ball_.notification("event", "effect_ended")["reason"], "stopped");
  EXPECT_EQ(device_.erased(), 0);
}

TEST_F(Gamepad, ASpringIsRefused) {
  ff_effect spring{};
  spring.type = FF_SPRING;
  EXPECT_EQ(upload(spring), EINVAL);
  EXPECT_TRUE(eventually([&] { return !trace().empty(); }));
  EXPECT_EQ(trace().front(), "game: upload 0: type 0x53, endless: refused, Invalid argument");
}

TEST_F(Gamepad, TiltingTheBallMovesTheStick) {
  ASSERT_TRUE(eventually([&] { return device_.moved(); })) << "upright is the centre";
  turn(model::axis_angle({1, 0, 0}, 60));
  EXPECT_TRUE(eventually([&] { return device_.stick().x > 30'000; }));
  turn({});
  EXPECT_TRUE(eventually([&] { return device_.stick() == StickPosition{}; }));
}

TEST_F(Gamepad, AHungDaemonCentresTheStickAndItsConnectionEnds) {
  ASSERT_TRUE(eventually([&] { return device_.moved(); }));
  turn(model::axis_angle({1, 0, 0}, 60));
  ASSERT_TRUE(eventually([&] { return device_.stick().x > 30'000; }));
  daemon_.signal(SIGSTOP);
  EXPECT_TRUE(eventually([&] { return device_.stick() == StickPosition{}; }));
  EXPECT_TRUE(eventually([&] { return reports().back().ends_with("; reconnecting"); }))
      << testing::PrintToString(reports());
  EXPECT_EQ(upload(push_right(300)), 0) << "while the daemon hangs";
  daemon_.signal(SIGCONT);
  EXPECT_TRUE(eventually([&] { return device_.stick().x > 30'000; }));
  EXPECT_THAT(reports().back(), testing::HasSubstr("connected to "));
}

TEST(GamepadProgram, WithoutUinputItEndsWith69AndARemedy) {
  const Home home;
  const Ended ended = Program(home, hedgehog_gamepad(), {"--device", home.path("uinput")}).wait();
  EXPECT_EQ(ended.exit_code, 69);
  EXPECT_THAT(ended.err, testing::HasSubstr("modprobe uinput"));
  EXPECT_EQ(Program(home, hedgehog_gamepad(), {"--curve", "9"}).wait().exit_code, 64);
}

}  // namespace
}  // namespace hedgehog::e2e
