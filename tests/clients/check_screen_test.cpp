// SPDX-License-Identifier: MIT
// The output of `hedgehogctl check` for a monitoring plug-in.
#include "clients/ctl/screen/check_screen.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace hedgehog::client {
namespace {

Ball well() {
  Ball ball;
  ball.hello.limits.current_a = 15.0;
  ball.description.limits.derate_from_c = 60.0;
  ball.description.limits.trip_c = 70.0;
  protocol::Status& status = ball.status;
  status.device = "ball-7";
  status.state = "armed";
  status.limit_a = 15.0;
  status.temperature_c.sensor = 38.3;
  status.temperature_c.model = 41.2;
  status.loop.lateness_us.p99 = 60.0;
  status.current_a = {3.0, 4.0, 0.0};
  return ball;
}

TEST(CheckScreen, AHealthyBall) {
  const Check check = check_screen(well(), 2);
  EXPECT_EQ(check.code, 0);
  EXPECT_EQ(check.line,
            "HEDGEHOG OK - ball-7 armed, hottest winding 41.2 C, 15.0 A allowed | "
            "temperature=41.2;60;70 thermistor=38.3 current=5.0 limit=15.0 effects=0 "
            "lateness=60us;500 clients=2");
  EXPECT_THAT(check_screen(well(), {}).line, testing::EndsWith("lateness=60us;500"));
}

TEST(CheckScreen, ProblemsAreListedWorstFirst) {
  Ball ball = well();
  const auto expect = [&](int code, const std::string& begin) {
    const Check check = check_screen(ball, {});
    EXPECT_EQ(check.code, code) << check.line;
    EXPECT_THAT(check.line, testing::StartsWith(begin));
  };
  ball.status.loop.lateness_us.p99 = 500.0;
  expect(0, "HEDGEHOG OK - ball-7 armed, hottest winding 41.2 C, ");
  ball.status.loop.lateness_us.p99 = 501.0;
  expect(1, "HEDGEHOG WARNING - ball-7 armed, its loop is late, hottest winding 41.2 C, ");
  ball.status.temperature_c.sensor.reset();
  expect(1, "HEDGEHOG WARNING - ball-7 armed, no temperature from its thermistor, hottest winding");
  ball.status.temperature_c = {.sensor = 38.3};
  expect(1,
         "HEDGEHOG WARNING - ball-7 armed, no temperature, 15.0 A allowed | thermistor=38.3 "
         "current=");
  ball.status.temperature_c = {};
  expect(1, "HEDGEHOG WARNING - ball-7 armed, no temperature, 15.0 A allowed | current=");
  ball.status.limit_a = 14.6;
  expect(1, "HEDGEHOG WARNING - ball-7 armed, derated, 14.6 A allowed");
  ball.status.reason = "too_hot";
  expect(1, "HEDGEHOG WARNING - ball-7 armed: too_hot, 14.6 A allowed");
  ball.status.state = "disarmed";
  ball.status.reason = "emergency_stop";
  expect(1, "HEDGEHOG WARNING - ball-7 disarmed: emergency_stop, ");
  ball.status.state = "absent";
  ball.status.reason = "no_board";
  expect(2, "HEDGEHOG CRITICAL - ball-7 absent: no_board, ");
  ball.status.state = "tripped";
  ball.status.reason = "sensor_open";
  expect(2, "HEDGEHOG CRITICAL - ball-7 tripped: sensor_open, ");
}

}  // namespace
}  // namespace hedgehog::client
