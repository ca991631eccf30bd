// SPDX-License-Identifier: MIT
// What the instrumentation allows, as hello and the forecast report it.
#include <gtest/gtest.h>

#include "tests/server/server_rig.h"

namespace hedgehog::server {
namespace {

struct Allowed {
  double burst_s = 0.0;
  double seconds_to_derating = 0.0;
};

/// 15 A from cold.
Allowed allowed_by(device::FrontEndKind kind, int thermistors) {
  device::SimulatedBoardOptions board;
  board.front_end.kind = kind;
  board.front_end.thermistors = thermistors;
  ServerRig rig({}, board);
  FakeClient& client = rig.connect();
  rig.run(500);
  return {rig.call(client, "hello")["limits"]["burst_s"],
          rig.call(client, "thermal.forecast", {{"current_a", 15}})["seconds_to_derating"]};
}

TEST(Instrumentation, ABetterMeasuredBallMayPlayLonger) {
  const Allowed three = allowed_by(device::FrontEndKind::kInLine, 3);
  const Allowed one = allowed_by(device::FrontEndKind::kInLine, 1);
  const Allowed driver_cs = allowed_by(device::FrontEndKind::kDriverCs, 1);
  EXPECT_NEAR(three.burst_s, 21.7, 1.0);
  EXPECT_LT(one.burst_s, three.burst_s);
  EXPECT_LT(driver_cs.burst_s, one.burst_s - 1.0);
  EXPECT_LT(one.seconds_to_derating, three.seconds_to_derating);
  EXPECT_LT(driver_cs.seconds_to_derating, one.seconds_to_derating - 1.0);
}

}  // namespace
}  // namespace hedgehog::server
