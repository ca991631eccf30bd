// SPDX-License-Identifier: MIT
// The error for a client that arms the ball too often.
#include <gtest/gtest.h>

#include "tests/server/server_rig.h"

namespace hedgehog::server {
namespace {

TEST(Arming, ThroughTheSameTripSaysHowLongToWait) {
  ServerRig rig;
  FakeClient& owner = rig.connect();
  Json answer;
  for (int times = 0; times < 4; ++times) {
    rig.call(owner, "sim.set", {{"fault", {{"faults", {"sensor_open"}}}}});
    rig.run(100);
    rig.call(owner, "sim.set", {{"fault", {{"faults", Json::array()}}}});
    rig.run(100);
    answer = rig.call(owner, "device.arm");
  }
  EXPECT_EQ(answer["code"], -32000);
  EXPECT_EQ(answer["message"],
            "not_armed: the ball is tripped (sensor_open). Check the coil thermometer's plug and "
            "wire, wait 10 s (it was armed again after this trip 3 times), then run: hedgehogctl "
            "arm");
  const int wait_ms = answer["data"]["retry_after_ms"];
  EXPECT_GT(wait_ms, 9000);
  rig.run(wait_ms);
  EXPECT_EQ(rig.call(owner, "device.arm")["state"], "armed");
}

}  // namespace
}  // namespace hedgehog::server
