// SPDX-License-Identifier: MIT
// The session with an MTi, against a simulated one that follows the protocol.
#include "daemon/device/imu/mti_session.h"

#include <gtest/gtest.h>

#include <string>

#include "tests/device/hex.h"
#include "tests/device/imu/fake_mti.h"
#include "tests/device/imu/mti_capture.h"

namespace hedgehog::device {
namespace {

void exchange(MtiSession& session, FakeMti& mti, double from_s, double until_s) {
  for (double t = from_s; t < until_s; t += 0.01) {
    const auto sent = session.due(t);
    session.receive(mti.respond(sent), t);
    if (mti.measuring) session.receive(from_hex(kCaptureA), t);
  }
}

TEST(MtiSession, ConfiguresThenMeasures) {
  MtiSession session;
  FakeMti mti;
  mti.measuring = true;  // as left by the last run
  exchange(session, mti, 0.0, 0.5);
  EXPECT_TRUE(session.measuring());
  EXPECT_EQ(mti.outputs, orientation_outputs(200));
  ASSERT_TRUE(session.next().has_value());
}

TEST(MtiSession, FallsBackToARateThatTheTrackerSupports) {
  MtiSession session;
  FakeMti mti;
  mti.highest_rate = 100;
  exchange(session, mti, 0.0, 2.0);
  EXPECT_TRUE(session.measuring());
  EXPECT_EQ(mti.outputs, orientation_outputs(100));
}

TEST(MtiSession, RestartsAfterSilenceAndAfterARestartOfTheTracker) {
  MtiSession session;
  FakeMti mti;
  exchange(session, mti, 0.0, 0.5);
  mti.measuring = false;
  mti.outputs.clear();
  exchange(session, mti, 0.5, 3.0);
  EXPECT_TRUE(session.measuring());
  EXPECT_FALSE(mti.outputs.empty());

  session.receive(encode_xbus(XbusId::kWakeUp), 3.0);
  EXPECT_EQ(session.due(3.0), encode_xbus(XbusId::kWakeUpAck));
  EXPECT_FALSE(session.measuring());
  exchange(session, mti, 3.0, 4.0);
  EXPECT_TRUE(session.measuring());
}

TEST(MtiSession, RepeatsARequestWithoutResponse) {
  MtiSession session;
  int requests = 0;
  for (double t = 0.0; t < 2.0; t += 0.01) requests += session.due(t).empty() ? 0 : 1;
  EXPECT_NEAR(requests, 10, 1);
}

}  // namespace
}  // namespace hedgehog::device
