// SPDX-License-Identifier: MIT
// The error for a client that arms the ball too often.
#include <gtest/gtest.h>

#include "tests/server/server_rig.h"

namespace hedgehog::server {
namespace {

TEST(Arming, AfterTheSameTripReturnsTheRemainingWait) {
  ServerRig rig;
  FakeClient& owner = rig.connect();
  Json response;
  for (int times = 0; times < 4; ++times) {
    rig.call(owner, "sim.set", {{"fault", {{"faults", {"sensor_open"}}}}});
    rig.run(100);
    rig.call(owner, "sim.set", {{"fault", {{"faults", Json::array()}}}});
    rig.run(100);
    response = rig.call(owner, "device.arm");
  }
  EXPECT_EQ(response["code"], -32000);
  EXPECT_EQ(response["message"],
            "not_armed: the ball is tripped (sensor_open). Check the coil thermometer's plug and "
            "wire, wait 10 s (it was armed again after this trip 3 times), then run: hedgehogctl "
            "arm");
  const int wait_ms = response["data"]["retry_after_ms"];
  EXPECT_GT(wait_ms, 9000);
  rig.run(wait_ms);
  EXPECT_EQ(rig.call(owner, "device.arm")["state"], "armed");
}

}  // namespace
}  // namespace hedgehog::server
