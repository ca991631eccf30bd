// SPDX-License-Identifier: MIT
// An emergency stop while the disk neither completes nor fails writing its latch.
#include <gtest/gtest.h>

#include "tests/e2e/timeout.h"
#include "tests/server/server_rig.h"

namespace hedgehog::server {
namespace {

TEST(SlowStop, IsAnsweredWhileTheLatchIsNotYetOnDisk) {
  ServerRig rig;
  FakeClient& owner = rig.connect();
  rig.state_store.persisted = Persisted::kPending;
  rig.server->line(owner.session, R"({"jsonrpc":"2.0","id":1,"method":"device.emergency_stop"})");
  // The timeout is in real time, unlike the ticks of the rig.
  ASSERT_TRUE(e2e::wait_until([&] {
    rig.run(1);
    return !owner.lines.empty();
  }));
  const Json result = Json::parse(owner.lines[0].text)["result"];
  EXPECT_EQ(result["state"], "disarmed");
  EXPECT_EQ(result["on_disk"], false);
}

}  // namespace
}  // namespace hedgehog::server
