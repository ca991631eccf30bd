// SPDX-License-Identifier: MIT
// device.enter_boot_loader: its roles, its preconditions, and the events for other clients.
#include <gtest/gtest.h>

#include "tests/server/server_rig.h"

namespace hedgehog::server {
namespace {

constexpr const char* kMethod = "device.enter_boot_loader";

struct BootLoader : testing::Test {
  ServerRig rig;
  FakeClient& owner = rig.connect();

  void stop() { rig.call(owner, "device.emergency_stop"); }
  Json status() { return rig.call(owner, "device.status"); }
};

TEST_F(BootLoader, IsNotForAnArmedBall) {
  rig.call(owner, "effect.hold", {{"direction", "left"}, {"lease_ms", 9000}});
  rig.run(100);
  const Json refused = rig.call(owner, kMethod);
  EXPECT_EQ(refused["code"], -32010);
  EXPECT_EQ(refused["message"],
            "armed: the boot loader can be entered only while the ball is not armed. Run: "
            "hedgehogctl stop");
  EXPECT_EQ(refused["data"],
            Json({{"name", "armed"}, {"state", "armed"}, {"remedy", "Run: hedgehogctl stop"}}));
  rig.run(200);
  EXPECT_EQ(status()["state"], "armed");
  EXPECT_NEAR(rig.plant_current_a(), 5.0, 0.2);
}

TEST_F(BootLoader, IsForOperators) {
  stop();
  FakeClient& player = rig.connect(protocol::Role::kPlay);
  EXPECT_EQ(rig.call(player, kMethod)["code"], -32004);
}

TEST_F(BootLoader, ADisarmedBoardDisappearsWithoutATrip) {
  stop();
  rig.call(owner, "events.subscribe", {{"types", {"state_changed"}}});
  const Json absent = rig.call(owner, kMethod);
  EXPECT_EQ(absent["state"], "absent");
  EXPECT_EQ(absent["reason"], "boot_loader");
  EXPECT_EQ(absent["remedy"], "Wait until the simulated board is back, after 3 s");
  EXPECT_EQ(status()["reason"], "boot_loader");
  rig.run(10);
  const auto events = rig.on_event(owner);
  ASSERT_EQ(events.size(), 1u);
  EXPECT_EQ(events[0]["state"], "absent");
  EXPECT_EQ(events[0]["reason"], "boot_loader");
  EXPECT_FALSE(events[0].contains("current_a")) << "as a trip would have";
  for (const auto& [reason, count] : rig.server->counters().trips) EXPECT_EQ(count, 0) << reason;
  EXPECT_EQ(rig.call(owner, "events.history", {{"trips", true}})["events"], Json::array());
  const Json board = rig.call(owner, "device.describe")["board"];
  EXPECT_EQ(board["present"], false);
  EXPECT_EQ(board["protocol"], nullptr);
  EXPECT_EQ(rig.call(owner, kMethod)["code"], -32005) << "it is there already";
}

TEST_F(BootLoader, AReturnedBoardIsArmedByRequestOnly) {
  stop();
  rig.call(owner, kMethod);
  rig.run(3200);
  EXPECT_EQ(status()["state"], "disarmed");
  EXPECT_EQ(rig.call(owner, "device.describe")["board"]["protocol"], "1.2");
  EXPECT_EQ(rig.call(owner, "device.arm")["state"], "armed");
}

TEST_F(BootLoader, ArmingMeanwhileIsRefusedWithTheReason) {
  stop();
  const std::string line = R"([{"jsonrpc":"2.0","id":1,"method":"device.enter_boot_loader"},)"
                           R"({"jsonrpc":"2.0","id":2,"method":"device.arm"}])";
  const Json responses = rig.exchange(owner, line);
  ASSERT_EQ(responses.size(), 2u);
  EXPECT_EQ(responses[0]["result"]["reason"], "boot_loader");
  EXPECT_EQ(responses[1]["error"]["data"]["reason"], "boot_loader");
}

TEST_F(BootLoader, ARequestAfterAnArmingIsRefusedWithTheReason) {
  stop();
  const std::string line = R"([{"jsonrpc":"2.0","id":1,"method":"device.arm"},)"
                           R"({"jsonrpc":"2.0","id":2,"method":"device.enter_boot_loader"}])";
  const Json responses = rig.exchange(owner, line);
  ASSERT_EQ(responses.size(), 2u);
  EXPECT_EQ(responses[0]["result"]["state"], "armed");
  EXPECT_EQ(responses[1]["error"]["data"]["name"], "armed");
}

TEST_F(BootLoader, AnUnsupportingBoardGetsNoRequest) {
  stop();
  control::StatusSnapshot older = rig.device_view->now();
  older.board.protocol_minor = 1;
  rig.mailbox->status.write(older);
  rig.device_view->refresh();
  const Json refused = rig.call(owner, kMethod);
  EXPECT_EQ(refused["code"], -32006);
  EXPECT_EQ(refused["message"],
            "unsupported: the board speaks 1.1 of the board protocol; entering the boot loader on "
            "request requires 1.2 or later; unplug it and hold BOOTSEL while plugging it in");
  rig.run(300);
  EXPECT_EQ(status()["state"], "disarmed");
}

TEST_F(BootLoader, ABoardThatDoesNotEnterItIsReported) {
  stop();
  rig.server->line(owner.session,
                   R"({"jsonrpc":"2.0","id":1,"method":"device.enter_boot_loader"})");
  for (int i = 0; i < 600 && owner.lines.empty(); ++i) {
    rig.control->run(rig.device_view->now().tick + 1, 0, {});
    device::LinkCommand command = rig.port->commands.read();
    command.board.boot_loader_count = 0;
    rig.port->commands.write(command);
    rig.world.step();
    rig.server->pump();
  }
  ASSERT_FALSE(owner.lines.empty());
  const Json error = Json::parse(owner.lines.front().text)["error"];
  EXPECT_EQ(error["message"], "busy: the board has not entered its boot loader");
  EXPECT_EQ(error["data"]["retry_after_ms"], 1000);
}

}  // namespace
}  // namespace hedgehog::server
