// SPDX-License-Identifier: MIT
// The current that heat allows, as reported to a client: never above the configured limit, and with
// the reason when it is zero.
#include <gtest/gtest.h>

#include <limits>
#include <memory>

#include "daemon/server/device/device_view.h"
#include "tests/server/server_rig.h"

namespace hedgehog::server {
namespace {

/// The control thread's status, without the thread.
class TooHot : public testing::Test {
 protected:
  TooHot() {
    snapshot_.tick = 1;
    snapshot_.state = control::State::kArmed;
    snapshot_.reason = control::Reason::kNone;
    snapshot_.limit_a = 15.0;
    snapshot_.thermal.hottest_c = 30.0;
    show();
  }
  void show() {
    mailbox_->status.write(snapshot_);
    view_.refresh();
  }

  std::unique_ptr<control::Mailbox> mailbox_ = std::make_unique<control::Mailbox>();
  std::unique_ptr<device::LinkPort> port_ = std::make_unique<device::LinkPort>();
  control::StatusSnapshot snapshot_;
  DeviceView view_{config::Config{}, *mailbox_, *port_, 0};
};

TEST_F(TooHot, AnArmedBallThatMayPlayHasNoReason) {
  EXPECT_EQ(view_.reason_now(), std::nullopt);
  EXPECT_EQ(view_.remedy_now(), std::nullopt);
  snapshot_.limit_a = 5.0;
  show();
  EXPECT_EQ(view_.reason_now(), std::nullopt) << "derated";
}

TEST_F(TooHot, AnArmedBallThatMayNotReportsTheHotPart) {
  snapshot_.limit_a = 0.0;
  snapshot_.thermal.hottest_c = 143.2;
  show();
  EXPECT_EQ(view_.reason_now(), "too_hot");
  EXPECT_EQ(view_.remedy_now(),
            "Wait until the hottest winding is below 67 °C; the upper bound of its temperature is "
            "143 °C");
  snapshot_.thermal.hottest_c = 50.0;
  snapshot_.skin.bound_c = 47.6;
  show();
  EXPECT_EQ(view_.remedy_now(),
            "Wait until the shell is cooler: the upper bound of its temperature is 48 °C");
  snapshot_.skin.bound_c = std::numeric_limits<double>::infinity();
  show();
  EXPECT_EQ(view_.remedy_now(), "Wait until the temperature of the shell has been measured");
}

TEST_F(TooHot, ABallThatIsNotArmedKeepsItsOwnReason) {
  snapshot_.limit_a = 0.0;
  snapshot_.thermal.hottest_c = std::numeric_limits<double>::infinity();
  snapshot_.state = control::State::kTripped;
  snapshot_.reason = control::Reason::kSensorOpen;
  show();
  EXPECT_EQ(view_.reason_now(), "sensor_open");
}

TEST_F(TooHot, TheLimitThatIsShownIsNeverAboveTheConfiguredOne) {
  EXPECT_EQ(view_.shown_limit_a(14.996), 15.0);
  EXPECT_EQ(view_.shown_limit_a(7.774), 7.77);
  config::Config config;
  config.limits.current_a = 7.777;
  view_.set_config(config);
  EXPECT_EQ(view_.shown_limit_a(7.777), 7.777) << "7.78 is more";
  EXPECT_EQ(view_.shown_limit_a(15.0), 7.777) << "control has not taken the new limits yet";
}

TEST(HotStart, ABallTooHotToHoldIsArmedAndReportsWhyNothingPlays) {
  ServerRig rig({}, {.start_c = 60.0});
  FakeClient& client = rig.connect();
  for (const char* method : {"hello", "device.status", "events.subscribe"}) {
    const Json now = rig.call(client, method);
    EXPECT_EQ(now["state"], "armed") << method;
    EXPECT_EQ(now["reason"], "too_hot") << method;
  }
  const Json status = rig.call(client, "device.status");
  EXPECT_LT(status["limit_a"], rig.config.limits.felt_a);
  EXPECT_NE(status["remedy"].get<std::string>().find("shell"), std::string::npos);
}

TEST(ShownLimit, OfStatusAndEventsIsWithinThatOfHello) {
  config::Config config;
  config.limits.current_a = 7.777;
  ServerRig rig(config);
  FakeClient& client = rig.connect();
  EXPECT_EQ(rig.call(client, "hello")["limits"]["current_a"], 7.777);
  EXPECT_EQ(rig.call(client, "device.status")["limit_a"], 7.777);
  EXPECT_EQ(rig.call(client, "events.subscribe")["limit_a"], 7.777);
}

}  // namespace
}  // namespace hedgehog::server
