// SPDX-License-Identifier: MIT
// hedgehogctl used by a person and by a script: its output and its exit codes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include "tests/e2e/busy_machine.h"
#include "tests/e2e/daemon_process.h"
#include "tests/e2e/exit_codes.h"
#include "tests/e2e/program.h"
#include "tests/e2e/programs.h"
#include "tests/e2e/raw_client.h"

namespace hedgehog::e2e {
namespace {

using testing::ContainsRegex;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

class Ctl : public testing::Test {
 protected:
  std::vector<std::string> variables() const { return {"HEDGEHOG_ADDRESS=" + daemon_.socket()}; }
  /// `renew` is called repeatedly.
  Ended ctl(
      const std::vector<std::string>& arguments, const std::function<void()>& renew = [] {}) const {
    Program program(home_, hedgehogctl(), arguments, variables());
    return wait_renewing(program, renew);
  }
  /// Starts a push to the left, or renews it.
  void push(double strength_a) {
    renew_hold(other_, {{"direction", "left"}, {"current_a", strength_a}});
  }
  /// The largest coil current of either sign.
  double current_a() {
    const Json currents = other_.call("device.status")["current_a"];
    double max_a = 0.0;
    for (const Json& current : currents) max_a = std::max(max_a, std::abs(current.get<double>()));
    return max_a;
  }

  Home home_;
  DaemonProcess daemon_{home_};
  RawClient other_{daemon_.port()};
};

TEST_F(Ctl, StatusIsPrintedForPeopleAndForPrograms) {
  const Ended text = ctl({"status"});
  EXPECT_EQ(text.exit_code, 0);
  EXPECT_THAT(text.err, IsEmpty());
  for (const char* word :
       {"ball · armed", "SIMULATED", "temperature ", "current ", "force ", "headroom ", "coils ",
        "fan ", "orientation ", "loop ", "playing        nothing", "last trip         none"})
    EXPECT_THAT(text.out, HasSubstr(word));
  EXPECT_THAT(text.out, Not(HasSubstr("\033"))) << "no colour into a file";
  const Ended json = ctl({"status", "--json"});
  EXPECT_EQ(json.exit_code, 0);
  const Json printed = Json::parse(json.out);
  const Json status = other_.call("device.status");
  for (const auto& [key, value] : status.items()) EXPECT_TRUE(printed.contains(key)) << key;
  EXPECT_EQ(printed["state"], "armed");
}

TEST_F(Ctl, PlayingVerbsRunUntilTheEffectHasEnded) {
  struct Case {
    std::vector<std::string> words;
    const char* line;
  };
  const Case cases[] = {
      {{"pulse", "left"}, "^pulse left +5\\.0 A +0\\.06[0-9] N at pin 34 +150 ms +completed\n$"},
      {{"circle"}, "^circle +5\\.0 A .* at pin 46 +1500 ms +completed\n$"},
      {{"circle", "--duration-ms", "300"}, "^circle +5\\.0 A .* at pin 46 +300 ms +completed\n$"},
      {{"circle", "--lease-ms", "500", "--for", "0.2"}, "^circle .* ms +completed\n$"},
      {{"vibrate", "--duration-ms", "200"}, "^vibrate +5\\.0 A .* 200 ms +completed\n$"},
      {{"hold", "up", "--for", "0.3"}, "^hold up +5\\.0 A .* at pin 0 +[0-9]+ ms +completed\n$"},
      {{"pulse", "34", "--current-a", "8", "--duration-ms", "100"},
       "^pulse 34 +8\\.0 A .* at pin 34 +100 ms +completed\n$"},
      {{"pulse", "90,0"}, "at pin 34 .*completed"},
      {{"pulse", "0,1,0"}, "at pin 34 .*completed"},
  };
  for (const Case& each : cases) {
    const Ended ended = play_unexpired([&] { return ctl(each.words); });
    EXPECT_EQ(ended.exit_code, 0) << ended.err;
    EXPECT_THAT(ended.out, ContainsRegex(each.line));
  }
  const Ended json = ctl({"pulse", "left", "--json"});
  std::istringstream lines(json.out);
  std::string admission;
  std::string event;
  ASSERT_TRUE(std::getline(lines, admission) && std::getline(lines, event));
  EXPECT_EQ(Json::parse(admission)["pin"], 34);
  EXPECT_EQ(Json::parse(event)["reason"], "completed");
}

TEST_F(Ctl, AnEffectEndedByAnotherClientExitsWith1) {
  const Ended ended = play_unexpired([&] {
    other_.call("device.arm");
    Program hold(home_, hedgehogctl(), {"hold", "up"}, variables());
    EXPECT_TRUE(hold.prints("hold up"));
    // An effect that ends before its first tick counts as delivered to 0 %.
    EXPECT_TRUE(eventually([&] { return current_a() > 4.0 || has_ended(hold); }));
    other_.call("device.emergency_stop");
    return hold.wait();
  });
  EXPECT_EQ(ended.exit_code, kEndedOtherwise);
  EXPECT_THAT(ended.out, ContainsRegex("ms   tripped\n$"));
}

TEST_F(Ctl, CtrlCExitsWith130AndTheCoilsGoToZero) {
  const Ended ended = play_unexpired([&] {
    Program hold(home_, hedgehogctl(), {"hold", "up", "--current-a", "8"}, variables());
    EXPECT_TRUE(eventually([&] { return current_a() > 6.0 || has_ended(hold); }));
    hold.signal(SIGINT);
    return hold.wait();
  });
  EXPECT_EQ(ended.exit_code, kInterrupted);
  EXPECT_THAT(ended.out, HasSubstr("interrupted"));
  EXPECT_TRUE(eventually([&] { return current_a() < 0.05; }));
  EXPECT_EQ(other_.call("device.status")["state"], "armed");
}

TEST_F(Ctl, CheckIsOkExceptForALateLoopOfABusyMachineAndCountsTheOthers) {
  const std::string well = "^HEDGEHOG (OK - ball armed|WARNING - ball armed, its loop is late), ";
  other_.call("hello");
  EXPECT_THAT(ctl({"check"}).out, ContainsRegex(well + "[^|]* \\| temperature=.* clients=1\n$"));
  other_.close();
  EXPECT_TRUE(eventually(
      [&] { return std::regex_search(ctl({"check"}).out, std::regex(" clients=0\n$")); }));
}

TEST_F(Ctl, StopLatchesUntilArm) {
  EXPECT_EQ(ctl({"stop"}).exit_code, 0);
  const Json status = other_.call("device.status");
  EXPECT_EQ(status["state"], "disarmed");
  EXPECT_EQ(status["reason"], "emergency_stop");
  const Ended refused = ctl({"pulse", "left"});
  EXPECT_EQ(refused.exit_code, kUnavailable);
  EXPECT_THAT(refused.out, IsEmpty());
  EXPECT_THAT(refused.err, HasSubstr("hedgehogctl arm"));
  EXPECT_THAT(ctl({"status"}).out, HasSubstr("The coils are off and stay off."));
  const Ended check = ctl({"check"});
  EXPECT_EQ(check.exit_code, 1);
  EXPECT_THAT(check.out, testing::StartsWith("HEDGEHOG WARNING - ball disarmed: emergency_stop"));
  const Ended arm = ctl({"arm"});
  EXPECT_EQ(arm.exit_code, 0) << arm.err;
  EXPECT_THAT(arm.out, HasSubstr("ball is armed."));
  EXPECT_EQ(ctl({"pulse", "left"}).exit_code, 0);
}

TEST_F(Ctl, GainIsSetAndPrinted) {
  EXPECT_THAT(ctl({"gain"}).out, HasSubstr("gain 1.00"));
  EXPECT_THAT(ctl({"gain", "0.5"}).out, HasSubstr("gain 0.50"));
  EXPECT_EQ(Json::parse(ctl({"gain", "--json"}).out)["gain"], 0.5);
  EXPECT_EQ(other_.call("device.describe")["gain"], 0.5);
  const Ended wrong = ctl({"gain", "3"});
  EXPECT_EQ(wrong.exit_code, kUsage);
  EXPECT_THAT(wrong.err, HasSubstr("gain: 3 is above 1"));
}

TEST_F(Ctl, ForecastPrintsTheTime) {
  const Ended text = ctl({"forecast", "15", "left"});
  EXPECT_EQ(text.exit_code, 0);
  EXPECT_THAT(text.out, ContainsRegex("15\\.0 A from now, left:\n  derated +in [0-9]+ s\n"));
  EXPECT_THAT(ctl({"forecast", "5"}).out, ContainsRegex("derated +never"));
  const Json json = Json::parse(ctl({"forecast", "15", "--json"}).out);
  EXPECT_GT(json["seconds_to_limit"], json["seconds_to_derating"]);
  EXPECT_GT(json["sustainable_a"], 5.0);
}

TEST_F(Ctl, EventsArePrintedUntilCtrlC) {
  Program events(home_, hedgehogctl(), {"events"}, variables());
  ASSERT_TRUE(events.prints("armed, 15.0 A allowed"));
  EXPECT_EQ(ctl({"pulse", "left"}).exit_code, 0);
  EXPECT_TRUE(events.prints("effect_started  #"));
  EXPECT_TRUE(events.prints("  completed, 150 ms"));
  other_.call("device.emergency_stop");
  EXPECT_TRUE(events.prints("state_changed  disarmed: emergency_stop"));
  events.signal(SIGINT);
  EXPECT_EQ(events.wait().exit_code, kInterrupted);
}

TEST_F(Ctl, EventsContinueAfterTheHistory) {
  EXPECT_EQ(ctl({"pulse", "left"}).exit_code, 0);
  Program events(home_, hedgehogctl(),
                 {"events", "--since", "1h", "-f", "--types", "effect_ended", "--json"},
                 variables());
  ASSERT_TRUE(events.prints("effect_ended"));
  EXPECT_EQ(ctl({"pulse", "right"}).exit_code, 0);
  const auto printed = [&] {
    std::vector<int> effects;
    std::istringstream lines(events.out());
    for (std::string line; std::getline(lines, line);)
      effects.push_back(Json::parse(line)["effect"]);
    return effects;
  };
  ASSERT_TRUE(eventually([&] { return printed().size() == 2; })) << events.out();
  EXPECT_NE(printed()[0], printed()[1]);
  events.signal(SIGINT);
  EXPECT_EQ(events.wait().exit_code, kInterrupted);
  EXPECT_EQ(ctl({"events", "--since", ""}).exit_code, kUsage);
}

TEST_F(Ctl, TelemetryIsOneObjectALine) {
  const Ended ended =
      ctl({"telemetry", "--count", "3", "--fields", "temperature_c,pin", "--rate-hz", "50"});
  EXPECT_EQ(ended.exit_code, 0);
  std::istringstream lines(ended.out);
  int count = 0;
  for (std::string line; std::getline(lines, line); ++count) {
    const Json printed = Json::parse(line);
    EXPECT_EQ(printed.size(), 3u) << line;
    EXPECT_TRUE(printed.contains("temperature_c") && printed.contains("pin")) << line;
  }
  EXPECT_EQ(count, 3);
  EXPECT_EQ(ctl({"telemetry", "--fields", "bogus"}).exit_code, kUsage);
}

TEST_F(Ctl, ClientsListsTheEffectsOfEach) {
  other_.call("hello", {{"client", "Racer/1.2"}});
  const Json hold{{"direction", "left"}, {"lease_ms", 10'000}};
  const Ended ended = ctl({"clients"}, [&] { other_.call("effect.hold", hold); });
  EXPECT_EQ(ended.exit_code, 0);
  EXPECT_THAT(ended.out, ContainsRegex("Racer/1\\.2 +tcp +- +- +operate .* hold"));
  EXPECT_THAT(ended.out, ContainsRegex("hedgehogctl +unix +[0-9]+ +[0-9]+ +operate "));
}

TEST_F(Ctl, PinsShowsThePush) {
  EXPECT_THAT(ctl({"pins"}).out, testing::EndsWith("● strong\n"));
  const auto renew = [&] { push(12.0); };
  ASSERT_TRUE(eventually([&] {
    renew();
    return current_a() > 11.0;
  }));
  const Ended ended = ctl({"pins"}, renew);
  EXPECT_THAT(ended.out, HasSubstr("●"));
  EXPECT_THAT(ended.out, ContainsRegex("0\\.1[0-9]+ N, 0\\.1[0-9] mm at pin 34\n"));
  const Json pins = Json::parse(ctl({"pins", "--json"}, renew).out)["pins"];
  EXPECT_NEAR(pins["force_n"][34], 0.148, 0.005);
  EXPECT_NEAR(pins["extension_mm"][34], 0.183, 0.01);

  const Ended lines = ctl({"pins", "--live", "--count", "2"}, renew);
  EXPECT_EQ(lines.exit_code, 0);
  EXPECT_EQ(std::count(lines.out.begin(), lines.out.end(), '\n'), 2);
  EXPECT_THAT(lines.out,
              ContainsRegex(" s +1[12]\\.[0-9] A +0\\.1[0-9]+ N +\\+0\\.[12][0-9]+ mm at "
                            "pin [0-9]+ +[0-9]+ out, [0-9]+ in\n"));
  const Ended json = ctl({"pins", "--live", "--count", "1", "--json"});
  EXPECT_EQ(Json::parse(json.out)["pins"]["extension_mm"].size(), 86u);
  EXPECT_EQ(ctl({"pins", "--count", "2"}).exit_code, kUsage);
}

TEST_F(Ctl, UsageErrorsExitWith64) {
  const std::vector<std::pair<std::vector<std::string>, const char*>> usage_errors{
      {{"frobnicate"}, "there is no verb 'frobnicate'"},
      {{"pulse", "sideways"}, "there is no 'sideways'"},
      {{"pulse", "99"}, "99 is above 85"},
      {{"pulse", "1,2,3,4"}, "1,2,3,4"},
      {{"pulse"}, "direction is required"},
      {{"pulse", "left", "--loud", "3"}, "hedgehogctl pulse: unknown option '--loud'"},
      {{"pulse", "left", "--duration-ms", "99999"}, "99999 is above 10000"},
      {{"pulse", "left", "--current-a", "3", "--level", "1"}, "only one of"},
      {{}, "a verb is missing"},
      {{"status", "--address", "foo:bar"}, "is no address of a daemon"},
      {{"watch"}, "needs a terminal"},
  };
  for (const auto& [words, error_message] : usage_errors) {
    const Ended ended = ctl(words);
    EXPECT_EQ(ended.exit_code, kUsage) << error_message;
    EXPECT_THAT(ended.err, HasSubstr(error_message));
    EXPECT_THAT(ended.out, IsEmpty());
  }
}

TEST(CtlAlone, NamesTheAddressesTriedWhenNoDaemonResponds) {
  try {
    RawClient occupied(7586);
    GTEST_SKIP() << "a daemon runs on this machine";
  } catch (const std::runtime_error&) {
  }
  const Home home;
  const Ended status = Program(home, hedgehogctl(), {"status"}).wait();
  EXPECT_EQ(status.exit_code, kUnavailable);
  EXPECT_THAT(status.err, HasSubstr(home.path("run/hedgehog/hedgehogd.sock")));
  EXPECT_THAT(status.err, HasSubstr("127.0.0.1:7586"));
  EXPECT_THAT(status.err, HasSubstr("hedgehogd --simulate"));
  const Ended check = Program(home, hedgehogctl(), {"check"}).wait();
  EXPECT_EQ(check.exit_code, 2);
  EXPECT_THAT(check.out, testing::StartsWith("HEDGEHOG CRITICAL - no daemon answers"));
}

}  // namespace
}  // namespace hedgehog::e2e
