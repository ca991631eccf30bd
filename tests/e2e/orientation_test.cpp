// SPDX-License-Identifier: MIT
// hedgehog-orientation against a ball that is turned: the push stays up in the world frame, within
// the pin pitch, and an unknown orientation is not shown.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>
#include <ostream>
#include <string>
#include <vector>

#include "model/quaternion.h"
#include "model/vec3.h"
#include "tests/e2e/daemon_process.h"
#include "tests/e2e/json_vector.h"
#include "tests/e2e/program.h"
#include "tests/e2e/programs.h"
#include "tests/e2e/raw_client.h"

namespace hedgehog::e2e {
namespace {

using model::Quaternion;
using model::Vec3;
using testing::HasSubstr;

constexpr double kPinPitchDeg = 23.5;
constexpr double kDegrees = 180.0 / 3.14159265358979323846;
constexpr int kSamples = 30;

/// A ball that the test turns, and its measured currents.
class TurnedBall {
 public:
  explicit TurnedBall(const DaemonProcess& daemon)
      : observer_(daemon.port()), hand_(daemon.port()) {
    observer_.call("telemetry.subscribe",
                   {{"rate_hz", 100}, {"fields", {"current_a", "field", "orientation"}}});
  }
  Json turn(const Quaternion& q) { return hand_.call("sim.set", {{"orientation", json_of(q)}}); }
  Json feed(const Quaternion& q) {
    return hand_.call("orientation.set", {{"quaternion", json_of(q)}});
  }
  RawClient& hand() { return hand_; }

  /// Waits for the next telemetry.
  void await_telemetry() { now_ = observer_.notification("telemetry"); }
  double current_a() const { return norm(vector_of(now_["current_a"])); }
  /// At least `current_a` is measured while the field is on: the measurement is one frame older
  /// than the field, so at the end of a push it may be non-zero when no current is requested any
  /// more.
  bool pushes(double current_a) const {
    return this->current_a() >= current_a && norm(vector_of(now_["field"])) > 0.5;
  }
  /// Angle between the field and up in the world frame when the ball is turned by `q`, in degrees.
  double from_up_deg(const Quaternion& q) const {
    const Vec3 field = vector_of(now_["field"]);
    const double up = rotate(q, field).z / std::max(norm(field), 1e-9);
    return std::acos(std::clamp(up, -1.0, 1.0)) * kDegrees;
  }
  /// Pushes with at least `current_a` now, upwards for a ball turned by `q`.
  bool pushes_up(const Quaternion& q, double current_a) const {
    return pushes(current_a) && from_up_deg(q) < kPinPitchDeg;
  }

 private:
  RawClient observer_;
  RawClient hand_;
  Json now_;
};

const std::vector<Quaternion>& turns() {
  static const std::vector<Quaternion> all{
      model::axis_angle({1, 0, 0}, 90), model::axis_angle({0, 1, 0}, -70),
      model::axis_angle({0.6, 0, 0.8}, 150), model::axis_angle({1, 0, 0}, 0)};
  return all;
}

struct Case {
  const char* loop;
  const char* style;
  double flows_a;  // minimum current of a push, in ampere

  friend void PrintTo(const Case& c, std::ostream* out) { *out << c.loop << ", " << c.style; }
};

class Indicator : public testing::TestWithParam<Case> {
 protected:
  std::vector<std::string> variables(const DaemonProcess& daemon) const {
    return {"HEDGEHOG_ADDRESS=" + daemon.socket()};
  }
  std::vector<std::string> words(const std::vector<std::string>& more = {}) const {
    std::vector<std::string> all{"--loop", GetParam().loop, "--style", GetParam().style};
    all.insert(all.end(), more.begin(), more.end());
    return all;
  }
  Home home_;
};

TEST_P(Indicator, PointsUpInTheWorldForAnyOrientation) {
  DaemonProcess daemon(home_);
  TurnedBall turned_ball(daemon);
  Program program(home_, hedgehog_orientation(), words(), variables(daemon));
  for (const Quaternion& q : turns()) {
    ASSERT_FALSE(turned_ball.turn(q).contains("code"));
    ASSERT_TRUE(eventually([&] {
      turned_ball.await_telemetry();
      return turned_ball.pushes_up(q, GetParam().flows_a);
    })) << "never up at w "
        << q.w;
    // The direction stays: no sample with a current deviates by as much as the next pin.
    int pushing = 0;
    ASSERT_TRUE(eventually([&] {
      turned_ball.await_telemetry();
      if (turned_ball.pushes(GetParam().flows_a)) {
        ++pushing;
        EXPECT_LT(turned_ball.from_up_deg(q), kPinPitchDeg);
      }
      return pushing == kSamples;
    }));
  }
  EXPECT_TRUE(program.prints("up is up"));
  program.signal(SIGTERM);
  EXPECT_EQ(program.wait().exit_code, 130);
  EXPECT_TRUE(eventually([&] {
    turned_ball.await_telemetry();
    return turned_ball.current_a() < 0.05;
  }));
}

TEST_P(Indicator, ASilentSensorEndsThePushWhichResumesWithTheSensor) {
  home_.configure(R"({"imu": {"type": "external"}})");
  DaemonProcess daemon(home_);
  TurnedBall turned_ball(daemon);
  const Quaternion q = model::axis_angle({1, 0, 0}, 90);
  // A ball that has never received an orientation has no sensor, and the indicator is refused.
  ASSERT_TRUE(eventually([&] {
    turned_ball.feed(q);
    return turned_ball.hand().call("device.status")["orientation"].is_object();
  }));
  Program program(home_, hedgehog_orientation(), words(), variables(daemon));
  const auto feed_until_pushing_up = [&] {
    return eventually([&] {
      turned_ball.feed(q);
      turned_ball.await_telemetry();
      return turned_ball.pushes_up(q, GetParam().flows_a);
    });
  };
  ASSERT_TRUE(feed_until_pushing_up()) << program.out() << turned_ball.hand().call("device.status");
  // The pulse pauses for 425 ms between two pushes; a whole second without current means that it
  // has stopped.
  int quiet = 0;
  ASSERT_TRUE(eventually([&] {
    turned_ball.await_telemetry();
    quiet = turned_ball.current_a() < 0.05 ? quiet + 1 : 0;
    return quiet == 100;
  }));
  EXPECT_TRUE(program.prints("up is not known"));
  EXPECT_TRUE(feed_until_pushing_up());
  program.signal(SIGINT);
  EXPECT_EQ(program.wait().exit_code, 130);
}

TEST_P(Indicator, EndsAfterItsSecondsWith0AndWithoutCurrent) {
  DaemonProcess daemon(home_);
  TurnedBall turned_ball(daemon);
  Program program(home_, hedgehog_orientation(), words({"--seconds", "0.5"}), variables(daemon));
  const Ended ended = program.wait();
  EXPECT_EQ(ended.exit_code, 0) << ended.err;
  EXPECT_TRUE(eventually([&] {
    turned_ball.await_telemetry();
    return turned_ball.current_a() < 0.05 &&
           turned_ball.hand().call("device.status")["effects"].empty();
  }));
}

INSTANTIATE_TEST_SUITE_P(
    Loops, Indicator,
    testing::Values(Case{"daemon", "steady", 4.5}, Case{"client", "steady", 4.5},
                    Case{"daemon", "pulse", 10.0}, Case{"client", "pulse", 10.0}),
    [](const auto& each) { return std::string(each.param.loop) + "_" + each.param.style; });

TEST(IndicatorAlone, OnceEndsWith69WhenTheDaemonEnds) {
  const Home home;
  DaemonProcess daemon(home);
  Program program(home, hedgehog_orientation(), {"--once"},
                  {"HEDGEHOG_ADDRESS=" + daemon.socket()});
  ASSERT_TRUE(program.prints("up is up"));
  EXPECT_EQ(daemon.stop(), 0);
  const Ended ended = program.wait();
  EXPECT_EQ(ended.exit_code, 69);
  EXPECT_THAT(ended.err, HasSubstr("hedgehog-orientation: "));
  const Ended again = Program(home, hedgehog_orientation(), {"--once"},
                              {"HEDGEHOG_ADDRESS=" + home.path("nobody.sock")})
                          .wait();
  EXPECT_EQ(again.exit_code, 69);
  EXPECT_THAT(again.err, HasSubstr("no daemon answers at " + home.path("nobody.sock")));
}

TEST(IndicatorAlone, WaitsForADaemonToRestart) {
  const Home home;
  auto daemon = std::make_unique<DaemonProcess>(home);
  Program program(home, hedgehog_orientation(), {"--style", "steady"},
                  {"HEDGEHOG_ADDRESS=" + daemon->socket()});
  ASSERT_TRUE(program.prints("up is up"));
  EXPECT_EQ(daemon->stop(), 0);
  daemon = std::make_unique<DaemonProcess>(home);
  TurnedBall turned_ball(*daemon);
  EXPECT_TRUE(eventually([&] {
    turned_ball.await_telemetry();
    return turned_ball.pushes_up({}, 4.5);
  }));
  program.signal(SIGTERM);
  const Ended ended = program.wait();
  EXPECT_EQ(ended.exit_code, 130);
  EXPECT_THAT(ended.err, HasSubstr("waiting for the daemon"));
}

TEST(IndicatorAlone, ComesBackToAFullDaemonNoEarlierThanItAsks) {
  const Home home;
  home.configure(R"({"connections": {"max": 1}})");
  DaemonProcess daemon(home);
  auto other = std::make_unique<RawClient>(daemon.port());
  ASSERT_TRUE(other->call("ping").contains("time_ns"));
  const auto begun = std::chrono::steady_clock::now();
  Program program(home, hedgehog_orientation(),
                  {"--address", "127.0.0.1:" + std::to_string(daemon.port())});
  const auto refusals = [&] {
    const std::string err = program.err();
    int count = 0;
    for (std::size_t at = err.find("too many clients"); at != std::string::npos;
         at = err.find("too many clients", at + 1))
      ++count;
    return count;
  };
  ASSERT_TRUE(eventually([&] { return refusals() >= 3; })) << program.err();
  EXPECT_GE(std::chrono::steady_clock::now() - begun, std::chrono::seconds(2))
      << "retry_after_ms is 1000";
  other.reset();
  EXPECT_TRUE(program.prints("up is up"));
}

TEST(IndicatorAlone, EndsWith69WhenItsTokenIsRefused) {
  const Home home;
  DaemonProcess daemon(home);
  const Ended ended = Program(home, hedgehog_orientation(), {},
                              {"HEDGEHOG_ADDRESS=" + daemon.socket(), "HEDGEHOG_TOKEN=wrong"})
                          .wait();
  EXPECT_EQ(ended.exit_code, 69);
  EXPECT_EQ(ended.err, "hedgehog-orientation: token: unknown or revoked\n");
}

TEST(IndicatorAlone, DoesNotPushAfterAnEmergencyStop) {
  const Home home;
  DaemonProcess daemon(home);
  RawClient other(daemon.port());
  Program program(home, hedgehog_orientation(), {}, {"HEDGEHOG_ADDRESS=" + daemon.socket()});
  ASSERT_TRUE(program.prints("up is up"));
  other.call("device.emergency_stop");
  const Ended stopped = program.wait();
  EXPECT_EQ(stopped.exit_code, 69);
  EXPECT_THAT(stopped.err, HasSubstr("the effect was ended: tripped"));
  const Ended refused =
      Program(home, hedgehog_orientation(), {}, {"HEDGEHOG_ADDRESS=" + daemon.socket()}).wait();
  EXPECT_EQ(refused.exit_code, 69);
  EXPECT_THAT(refused.err, HasSubstr("hedgehogctl arm"));
}

TEST(IndicatorAlone, UsageErrorsExitWith64) {
  const Home home;
  for (const std::vector<std::string>& words : {std::vector<std::string>{"--loop", "sideways"},
                                                {"--seconds", "-1"},
                                                {"--loud"},
                                                {"--address", "foo:bar"}})
    EXPECT_EQ(Program(home, hedgehog_orientation(), words).wait().exit_code, 64);
}

}  // namespace
}  // namespace hedgehog::e2e
