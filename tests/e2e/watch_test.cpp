// SPDX-License-Identifier: MIT
// `hedgehogctl watch` and `pins --live` on a terminal of their own.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/e2e/busy_machine.h"
#include "tests/e2e/daemon_process.h"
#include "tests/e2e/program.h"
#include "tests/e2e/programs.h"
#include "tests/e2e/raw_client.h"

namespace hedgehog::e2e {
namespace {

constexpr const char* kEnter = "\033[?1049h";
constexpr const char* kRestoreScreen = "\033[?25h\033[?1049l";

class Watch : public testing::Test {
 protected:
  Home home_;
  DaemonProcess daemon_{home_};
  RawClient other_{daemon_.port()};
  TerminalProgram watch_{home_, hedgehogctl(), {"watch"}, {"HEDGEHOG_ADDRESS=" + daemon_.socket()}};
};

TEST_F(Watch, DrawsTheBallStopsItAtSpaceAndQuitsAtQ) {
  ASSERT_TRUE(watch_.shows(kEnter));
  EXPECT_TRUE(watch_.shows("SPACE stops   q quits"));
  EXPECT_TRUE(watch_.shows("▲"));
  EXPECT_TRUE(watch_.shows("back"));
  EXPECT_TRUE(watch_.shows("no force"));
  EXPECT_FALSE(watch_.is_restored());

  other_.call("events.subscribe", {{"types", {"state_changed"}}});
  const auto push = [&] { renew_hold(other_, {{"direction", "left"}, {"current_a", 12}}); };
  EXPECT_TRUE(shows_renewing(watch_, "●", push));
  EXPECT_TRUE(shows_renewing(watch_, "N at pin 34", push));
  EXPECT_TRUE(watch_.shows("effect_started"));

  watch_.type(" ");
  const Json changed = other_.notification("event", "state_changed");
  EXPECT_EQ(changed["state"], "disarmed");
  EXPECT_EQ(changed["reason"], "emergency_stop");
  EXPECT_TRUE(watch_.shows("disarmed: emergency_stop"));
  EXPECT_TRUE(watch_.shows("hedgehogctl arm"));

  watch_.type("q");
  EXPECT_EQ(watch_.wait(), 0);
  EXPECT_THAT(watch_.shown(), testing::EndsWith(kRestoreScreen));
  EXPECT_TRUE(watch_.is_restored());
}

TEST_F(Watch, IsRedrawnInTheNewWidthOfTheTerminal) {
  // "ball · armed · 15.0 A allowed" and the keys are 50 columns, the margins 3.
  const auto title = [](std::size_t columns) {
    return "15.0 A allowed" + std::string(columns - 53, ' ') + "SPACE stops";
  };
  ASSERT_TRUE(watch_.shows(title(80)));
  EXPECT_TRUE(watch_.shows("\033[32marmed\033[0m")) << "green";
  watch_.resize(140, 40);
  EXPECT_TRUE(watch_.shows(title(140))) << watch_.shown();
  const std::size_t drawn = watch_.shown().size();
  watch_.resize(60, 24);
  EXPECT_TRUE(eventually([&] {
    return watch_.shows("SPACE") && watch_.shown().find("\033[2J", drawn) != std::string::npos;
  })) << "from nothing";
  watch_.type("q");
  EXPECT_EQ(watch_.wait(), 0);
}

/// A space counts behind another key, behind the escape sequence of one, and before leaving.
TEST_F(Watch, ASpaceStopsAmongOtherKeys) {
  ASSERT_TRUE(watch_.shows("SPACE stops"));
  other_.call("events.subscribe", {{"types", {"state_changed"}}});
  for (const char* keys : {"x ", "\033[A ", "\033 ", "xxxxxxxxxxxxxxxxxxxxxxxxxxx ", " q"}) {
    SCOPED_TRACE(keys);
    watch_.type(keys);
    ASSERT_EQ(other_.notification("event", "state_changed")["reason"], "emergency_stop");
    other_.call("device.arm");
    ASSERT_EQ(other_.notification("event", "state_changed")["state"], "armed");
  }
  EXPECT_EQ(watch_.wait(), 0);
}

TEST_F(Watch, CtrlCLeavesTheTerminalAsItWas) {
  ASSERT_TRUE(watch_.shows("SPACE stops"));
  watch_.type("\x03");
  EXPECT_EQ(watch_.wait(), 130);
  EXPECT_THAT(watch_.shown(), testing::EndsWith(kRestoreScreen));
  EXPECT_TRUE(watch_.is_restored());
  EXPECT_EQ(other_.call("device.status")["state"], "armed");
}

TEST_F(Watch, ReportsTheEndOfTheDaemon) {
  ASSERT_TRUE(watch_.shows("SPACE stops"));
  EXPECT_EQ(daemon_.stop(), 0);
  EXPECT_EQ(watch_.wait(), 69);
  EXPECT_THAT(watch_.shown(), testing::HasSubstr(kRestoreScreen));
  EXPECT_THAT(watch_.shown(), testing::HasSubstr("the daemon ended the connection"));
  EXPECT_TRUE(watch_.is_restored());
}

TEST(LivePictures, MarkStaleDataAndAStopWithoutResponse) {
  Home home;
  // In lock-step: the time of the ball stops too, so that it reports no other error afterwards.
  DaemonProcess daemon(home, {"--speed", "1"});
  RawClient other(daemon.port());
  other.call("events.subscribe", {{"types", {"state_changed"}}});
  for (const std::vector<std::string>& verb :
       {std::vector<std::string>{"watch"}, {"pins", "--live"}}) {
    SCOPED_TRACE(verb.front());
    TerminalProgram view(home, hedgehogctl(), verb, {"HEDGEHOG_ADDRESS=" + daemon.socket()});
    ASSERT_TRUE(view.shows("A allowed"));
    daemon.signal(SIGSTOP);
    EXPECT_TRUE(view.shows("no data from hedgehogd: the values are out of date"));
    view.type(" ");
    EXPECT_TRUE(view.shows("stop sent, no answer: pull the plug"));
    daemon.signal(SIGCONT);
    EXPECT_EQ(other.notification("event", "state_changed")["reason"], "emergency_stop");
    EXPECT_TRUE(view.shows("disarmed: emergency_stop"));
    view.type("q");
    EXPECT_EQ(view.wait(), 0);
    other.call("device.arm");
    EXPECT_EQ(other.notification("event", "state_changed")["state"], "armed");
  }
}

TEST(LivePins, AreDrawnStoppedBySpaceAndQuitByQ) {
  Home home;
  DaemonProcess daemon(home);
  RawClient other(daemon.port());
  TerminalProgram pins(home, hedgehogctl(), {"pins", "--live"},
                       {"HEDGEHOG_ADDRESS=" + daemon.socket()});
  ASSERT_TRUE(pins.shows(kEnter));
  EXPECT_TRUE(pins.shows("hundredths of a millimetre out of rest"));
  EXPECT_TRUE(pins.shows("all pins rest"));
  const Json push{{"direction", {{"pin", 1}}}, {"current_a", 12}};
  EXPECT_TRUE(shows_renewing(pins, "rests 0.50 mm out", [&] { renew_hold(other, push); }));
  other.call("events.subscribe", {{"types", {"state_changed"}}});
  pins.type(" ");
  EXPECT_EQ(other.notification("event", "state_changed")["reason"], "emergency_stop");
  EXPECT_TRUE(pins.shows("hedgehogctl arm"));
  pins.type("q");
  EXPECT_EQ(pins.wait(), 0);
  EXPECT_THAT(pins.shown(), testing::EndsWith(kRestoreScreen));
  EXPECT_TRUE(pins.is_restored());
}

}  // namespace
}  // namespace hedgehog::e2e
