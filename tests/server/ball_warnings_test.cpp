// SPDX-License-Identifier: MIT
// Log lines about a ball that has a problem but is not stopped.
#include "daemon/server/device/ball_warnings.h"

#include <gtest/gtest.h>

#include "tests/server/server_rig.h"

namespace hedgehog::server {
namespace {

struct BallWarning : testing::Test {
  std::vector<std::string> new_warnings() {
    mailbox->status.write(now);
    device_view.refresh();
    return warnings.step(device_view);
  }

  std::unique_ptr<control::Mailbox> mailbox = std::make_unique<control::Mailbox>();
  std::unique_ptr<device::LinkPort> port = std::make_unique<device::LinkPort>();
  DeviceView device_view{config::Config{}, *mailbox, *port, 0};
  control::StatusSnapshot now;
  BallWarnings warnings;
};

TEST_F(BallWarning, AnImplausibleFanSpeedIsReportedOnceAndItsRecoveryToo) {
  EXPECT_TRUE(new_warnings().empty());
  now.fan_works = false;
  now.board.fan_rpm = 14'400.0;
  const auto sentences = new_warnings();
  ASSERT_EQ(sentences.size(), 1u);
  EXPECT_EQ(
      sentences[0].find("the fan's tachometer shows 14400/min; a working fan of 7200/min shows "
                        "5040 to 10800: the fan is treated as stopped."),
      0u);
  EXPECT_TRUE(new_warnings().empty());
  now.fan_works = true;
  EXPECT_EQ(new_warnings().size(), 1u);
}

TEST_F(BallWarning, R25ThatHasChangedSinceAnEarlierStartIsReportedOnce) {
  device_view.set_saved_r25({0.45, 0.45, 0.0});
  now.r25_ohm = {0.46, 0.42, 0.0};
  const auto sentences = new_warnings();
  ASSERT_EQ(sentences.size(), 1u);
  EXPECT_EQ(sentences[0].find("winding y: R25 is 0.4200 ohm at this start, 6.7 % less than the "
                              "0.4500 ohm of an earlier start."),
            0u)
      << sentences[0];
  now.r25_ohm[1] = 0.419;
  EXPECT_TRUE(new_warnings().empty()) << "this start's was reported already";
}

TEST_F(BallWarning, R25ThatDriftedFromTheDeviceFileIsReported) {
  device_view.set_saved_r25({0.0, 0.48, 0.48});
  now.r25_ohm = {0.0, 0.485, 0.46};
  const auto sentences = new_warnings();
  ASSERT_EQ(sentences.size(), 1u);
  EXPECT_NE(sentences[0].find("7.8 % more than the 0.4500 ohm in the device file"),
            std::string::npos)
      << sentences[0];
}

TEST(MeasuredR25, IsInTheDescriptionOnceAWindingHasCarriedItsReference) {
  device::SimulatedBoardOptions board;
  board.plant.r25_ohm = {0.45, 0.459, 0.45};
  ServerRig rig({}, board);
  rig.device_view->set_saved_r25({0.0, 0.45, 0.0});
  FakeClient& owner = rig.connect();
  const auto measured = [&] { return rig.call(owner, "device.describe")["coils"]["measured"]; };
  EXPECT_EQ(measured()[1]["r25_ohm"], nullptr);
  rig.call(owner, "effect.pulse",
           {{"direction", {0, 1, 0}}, {"current_a", 6}, {"duration_ms", 2500}});
  rig.run(2500);
  const Json windings = measured();
  EXPECT_NEAR(windings[1]["r25_ohm"], 0.459, 0.002);
  EXPECT_NEAR(windings[1]["from_file"], 0.02, 0.005);
  EXPECT_NEAR(windings[1]["from_kept"], 0.02, 0.005);
  EXPECT_EQ(windings[0]["r25_ohm"], nullptr) << "nothing flowed in it";
}

}  // namespace
}  // namespace hedgehog::server
