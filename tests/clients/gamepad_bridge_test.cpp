// SPDX-License-Identifier: MIT
// The gamepad bridge while its daemon is connecting, silent or absent; each daemon is scripted.
#include "clients/gamepad/bridge.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <future>
#include <string>
#include <thread>

#include "tests/clients/fake_daemon.h"
#include "tests/fake_gamepad.h"

namespace hedgehog::gamepad {
namespace {

using client::FakeDaemon;
using client::FakePeer;
using testing::HasSubstr;

constexpr const char* kWelcome =
    R"({"jsonrpc":"2.0","id":1,"result":{"server":"fake","protocol":"1.0","role":"play",)"
    R"("limits":{"current_a":15.0,"continuous_a":5.0,"felt_a":2.1}}})";

ff_effect rumble() {
  ff_effect effect{};
  effect.type = FF_RUMBLE;
  effect.u.rumble.strong_magnitude = 0xffff;
  effect.replay.length = 300;
  return effect;
}

std::string telemetry(const std::string& up) {
  return R"({"jsonrpc":"2.0","method":"telemetry","params":{"time_ns":1,"orientation":{"quaternion":)"
         R"({"w":1,"x":0,"y":0,"z":0},"up":)" +
         up + R"(,"rate_deg_s":[0,0,0],"age_ms":2}}})";
}

/// Runs a bridge on a thread of its own until the end of a conversation.
class GamepadBridge : public testing::Test {
 protected:
  void converse(const FakeDaemon::Script& script) {
    FakeDaemon daemon(script);
    BridgeOptions options;
    options.addresses = {daemon.address()};
    std::atomic<bool> stop = false;
    std::thread thread([&] {
      Bridge bridge(device_, options, [](const std::string&) {});
      (void)bridge.run([&] { return stop.load(); });
    });
    daemon.finish();
    stop = true;
    thread.join();
  }

  FakeGamepad device_;
};

TEST_F(GamepadBridge, AnswersAnUploadWhileItWaitsForTheResponseToHello) {
  std::promise<void> uploaded;
  device_.on_upload([&] { uploaded.set_value(); });
  converse([&](FakePeer& peer) {
    EXPECT_THAT(peer.read(), HasSubstr(R"("method":"hello")"));
    device_.command(UploadRequest{1, rumble()});
    uploaded.get_future().wait();
    peer.send_line(kWelcome);
    EXPECT_THAT(peer.read(), HasSubstr(R"("method":"telemetry.subscribe")"))
        << "the connection has not ended";
  });
  EXPECT_EQ(device_.uploaded(), 0);
}

TEST_F(GamepadBridge, SilenceCentresTheStickOfAnOpenConnectionAndIsFollowedByAPing) {
  converse([&](FakePeer& peer) {
    peer.read();
    peer.send_line(kWelcome);
    peer.read();
    peer.send_line(telemetry("[0,0,1]"));
    peer.send_line(telemetry("[0,0.8,0.6]"));
    EXPECT_EQ(device_.next_move(), StickPosition{}) << "the first orientation";
    EXPECT_EQ(device_.next_move(), (StickPosition{kStickEnd, 0}));
    EXPECT_EQ(device_.next_move(), StickPosition{}) << "no telemetry any more";
    EXPECT_THAT(peer.read(), HasSubstr(R"("method":"ping")"));
  });
}

TEST_F(GamepadBridge, EndsWithOnceWithoutADaemon) {
  BridgeOptions options;
  const client::SilentPort silent;
  options.addresses = {silent.address()};
  options.once = true;
  const auto ended = Bridge(device_, options, {}).run([] { return false; });
  ASSERT_FALSE(ended);
  EXPECT_EQ(ended.error().exit_code, 69);
  EXPECT_THAT(ended.error().message, HasSubstr("the daemon does not run: "));
}

}  // namespace
}  // namespace hedgehog::gamepad
