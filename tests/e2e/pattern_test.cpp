// SPDX-License-Identifier: MIT
// Patterns with a real daemon: the current that flows, how they end, what is stored, and
// hedgehogctl's commands.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
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

using testing::HasSubstr;
using testing::Not;

class Patterns : public testing::Test {
 protected:
  Ended ctl(const std::vector<std::string>& arguments) const {
    return Program(home_, hedgehogctl(), arguments, {"HEDGEHOG_ADDRESS=" + daemon_.socket()})
        .wait();
  }
  Json currents() { return other_.call("device.status")["current_a"]; }

  Home home_;
  DaemonProcess daemon_{home_};
  RawClient other_{daemon_.port()};
};

TEST_F(Patterns, APatternsCurrentsFlowThroughTheCoils) {
  const Json steps = Json::parse(R"([{"t_ms":0,"direction":"up","level":0.4,"ease":"step"},
      {"t_ms":400,"direction":"left","level":0.8,"ease":"step"},{"t_ms":800,"level":0}])");
  RawClient client(daemon_.port());
  client.call("telemetry.subscribe", {{"rate_hz", 100}, {"fields", {"current_a", "time_ns"}}});
  other_.call("events.subscribe", {{"scope", "all"}, {"types", {"effect_ended"}}});
  const Json a = client.call("effect.play", {{"keyframes", steps}, {"current_a", 10}});
  EXPECT_EQ(a["current_a"], 8.0);
  const Json ended = other_.notification("event");
  EXPECT_EQ(ended["reason"], "completed");
  double up_a = 0.0;
  double left_a = 0.0;
  for (double last_ns = 0.0; last_ns < ended["time_ns"];) {
    const Json telemetry = client.notification("telemetry");
    last_ns = telemetry["time_ns"];
    const Json& now = telemetry["current_a"];
    if (std::abs(now[1].get<double>()) < 0.2) up_a = std::max(up_a, now[2].get<double>());
    if (std::abs(now[2].get<double>()) < 0.2) left_a = std::max(left_a, now[1].get<double>());
  }
  EXPECT_NEAR(up_a, 4.0, 0.2);
  EXPECT_NEAR(left_a, 8.0, 0.3);
}

TEST_F(Patterns, ALoopEndsByItsLeaseOrWithItsConnection) {
  RawClient client(daemon_.port());
  client.call("events.subscribe");
  const Json loop{{"pattern", "orbit"}, {"loop", true}, {"lease_ms", 300}};
  client.call("effect.play", loop);
  EXPECT_EQ(client.notification("event", "effect_ended")["reason"], "expired");

  other_.call("events.subscribe", {{"scope", "all"}, {"types", {"effect_ended"}}});
  Json longer = loop;
  longer["lease_ms"] = 10'000;
  client.call("effect.play", longer);
  client.close();
  EXPECT_EQ(other_.notification("event")["reason"], "disconnected");
  EXPECT_TRUE(eventually([&] {
    const Json now = currents();
    return std::abs(now[0].get<double>()) + std::abs(now[1].get<double>()) < 0.2;
  }));
}

TEST_F(Patterns, HedgehogctlListsPlaysPutsGetsAndRemovesThem) {
  EXPECT_THAT(ctl({"patterns"}).out, HasSubstr("  heartbeat              860 ms  "));
  const Ended played = ctl({"play", "tick", "left", "--level", "0.5"});
  EXPECT_EQ(played.exit_code, 0) << played.err;
  EXPECT_THAT(played.out, HasSubstr("play tick left   7.5 A"));
  EXPECT_THAT(played.out, HasSubstr("25 ms   completed"));
  EXPECT_THAT(ctl({"play", "hartbeat"}).err, HasSubstr("did you mean 'heartbeat'?"));
  const Ended looped = play_unexpired([&] {
    return ctl({"play", "orbit", "--loop", "--for", "0.4"});
  });
  EXPECT_EQ(looped.exit_code, 0) << looped.out << looped.err;

  home_.write("mine.json", R"({"name":"acme/purr","keyframes":[{"t_ms":0,"level":1},
                               {"t_ms":60,"level":0}]})");
  const std::string file = home_.path("mine.json");
  EXPECT_EQ(ctl({"play", file}).exit_code, 0) << "without putting it";
  EXPECT_EQ(ctl({"patterns", "put", file}).exit_code, 0);
  EXPECT_EQ(Json::parse(ctl({"patterns", "get", "acme/purr"}).out)["keyframes"].size(), 2u);
  EXPECT_THAT(ctl({"--json", "patterns", "list"}).out, HasSubstr("acme/purr"));
  EXPECT_EQ(ctl({"patterns", "remove", "acme/purr"}).exit_code, 0);
  EXPECT_THAT(ctl({"patterns", "get", "acme/purr"}).err, HasSubstr("there is no 'acme/purr'"));
  EXPECT_EQ(ctl({"play", home_.path("none.json")}).exit_code, kNoInput);
  home_.write("bad.json", R"({"name":"a/b","keyframes":[]})");
  EXPECT_EQ(ctl({"patterns", "put", home_.path("bad.json")}).exit_code, kBadData);
}

TEST_F(Patterns, AnAhapIsImportedAndUnsupportedPartsAreReported) {
  home_.write("My Boing!.ahap", R"({"Version":1,"Pattern":[{"Event":{"Time":0,
      "EventType":"HapticTransient","EventParameters":[
      {"ParameterID":"HapticIntensity","ParameterValue":0.9},
      {"ParameterID":"HapticSharpness","ParameterValue":0.4}]}}]})");
  const std::string file = home_.path("My Boing!.ahap");
  const Ended shown = ctl({"patterns", "import", file});
  EXPECT_EQ(shown.exit_code, 0);
  EXPECT_THAT(shown.err, HasSubstr("HapticSharpness is left out"));
  EXPECT_EQ(Json::parse(shown.out)["name"], "imported/my-boing-");
  EXPECT_EQ(ctl({"patterns", "import", file, "--name", "acme/boing", "--put"}).exit_code, 0);
  EXPECT_EQ(ctl({"play", "acme/boing"}).exit_code, 0);
  home_.write("no.hjif", "{\"a\":");
  const Ended bad = ctl({"patterns", "import", home_.path("no.hjif")});
  EXPECT_EQ(bad.exit_code, kBadData);
  EXPECT_THAT(bad.err, HasSubstr("not JSON"));
}

TEST_F(Patterns, AFileOfAnotherFormatPlaysDirectly) {
  home_.write("Boing.ahap", R"({"Version":1,"Pattern":[{"Event":{"Time":0.05,
      "EventType":"HapticTransient","EventParameters":[
      {"ParameterID":"HapticIntensity","ParameterValue":1.0},
      {"ParameterID":"HapticSharpness","ParameterValue":0.4}]}}]})");
  home_.write("buzz.hjif", R"({"timescale":1000,"perceptions":[
      {"perception_modality":"Vibrotactile","channels":[{"gain":1.0,"bands":[
      {"band_type":"Curve","curve_type":"Linear","effects":[{"effect_type":"Basis","position":0,"keyframes":[
      {"relative_position":0,"amplitude_modulation":1.0},
      {"relative_position":40,"amplitude_modulation":0.5}]}]}]}]}]})");
  const Ended boing = ctl({"play", home_.path("Boing.ahap"), "left", "--level", "0.5"});
  EXPECT_EQ(boing.exit_code, 0) << boing.err;
  EXPECT_THAT(boing.out, HasSubstr("7.5 A"));
  EXPECT_THAT(boing.out, HasSubstr("75 ms   completed"));
  EXPECT_THAT(boing.err, HasSubstr("Boing.ahap: HapticSharpness is left out"));
  const Ended buzz = ctl({"play", home_.path("buzz.hjif"), "--json"});
  EXPECT_EQ(buzz.exit_code, 0) << buzz.err;
  EXPECT_THAT(buzz.out, HasSubstr(R"("reason":"completed")"));
  const Ended shown = ctl({"preview", "play", home_.path("buzz.hjif"), "--json"});
  EXPECT_EQ(shown.exit_code, 0) << shown.err;
  EXPECT_EQ(Json::parse(shown.out)["duration_ms"], 40) << shown.out;
}

TEST_F(Patterns, ABadFileOfAnotherFormatIsReportedWithThePosition) {
  home_.write("broken.ahap", R"({"Pattern":[})");
  const std::string file = home_.path("broken.ahap");
  const Ended broken = ctl({"play", file});
  EXPECT_EQ(broken.exit_code, kBadData);
  EXPECT_THAT(broken.err, HasSubstr(file + ": "));
  EXPECT_THAT(broken.err, HasSubstr("at byte 13"));
  EXPECT_EQ(ctl({"play", home_.path("none.hjif")}).exit_code, kNoInput);
  home_.write("Drum.midi", "MThd");
  const Ended other = ctl({"play", home_.path("Drum.midi")});
  EXPECT_EQ(other.exit_code, kBadData);
  EXPECT_THAT(other.err, HasSubstr(".json, .ahap or .hjif"));
}

TEST_F(Patterns, AnImportedPatternThatIsTooLongIsReported) {
  const auto ahap = [](const std::string& seconds) {
    return R"({"Version":1,"Pattern":[{"Event":{"Time":0,"EventType":"HapticContinuous",
        "EventDuration":)" +
           seconds + R"(,"EventParameters":[
        {"ParameterID":"HapticIntensity","ParameterValue":0.1}]}}]})";
  };
  home_.write("ten.ahap", ahap("10"));
  home_.write("long.ahap", ahap("30.5"));
  const std::string too_long =
      "it takes 30.5 s, one effect 10 s at most: play it with --loop --for 30.5";
  EXPECT_THAT(ctl({"patterns", "import", home_.path("ten.ahap")}).err, Not(HasSubstr("it takes")));
  EXPECT_THAT(ctl({"patterns", "import", home_.path("long.ahap")}).err, HasSubstr(too_long));
  const Ended put = ctl({"patterns", "import", home_.path("long.ahap"), "--put"});
  EXPECT_EQ(put.exit_code, 0);
  EXPECT_THAT(put.err, HasSubstr(too_long));
  EXPECT_EQ(put.out, "imported/long is stored: hedgehogctl play imported/long --loop --for 30.5\n");
  // The printed command works, and the same without its options does not.
  EXPECT_EQ(ctl({"play", "imported/long"}).exit_code, kUsage);
  const Ended played = play_unexpired([&] {
    Program play(home_, hedgehogctl(), {"play", "imported/long", "--loop", "--for", "30.5"},
                 {"HEDGEHOG_ADDRESS=" + daemon_.socket()});
    EXPECT_TRUE(play.prints("play imported/long"));
    play.signal(SIGINT);
    return play.wait();
  });
  EXPECT_EQ(played.exit_code, kInterrupted);
  // Played from a file, only its name is needed.
  Program file(home_, hedgehogctl(), {"play", home_.path("long.ahap")},
               {"HEDGEHOG_ADDRESS=" + daemon_.socket()});
  EXPECT_TRUE(file.prints("play"));
  EXPECT_TRUE(eventually([&] {
    const Json effects = other_.call("device.status")["effects"];
    return effects.size() == 1 && effects[0]["method"] == "effect.play";
  }));
  file.signal(SIGINT);
  EXPECT_EQ(file.wait().exit_code, kInterrupted);
}

TEST(PersistedPatterns, APatternPersistsOverAKill) {
  const Home home;
  {
    DaemonProcess daemon(home);
    RawClient client(daemon.port());
    client.call("pattern.put",
                {{"name", "acme/kept"},
                 {"keyframes", Json::parse(R"([{"t_ms":0,"level":1},{"t_ms":50,"level":0}])")}});
    daemon.stop(SIGKILL);
  }
  DaemonProcess daemon(home);
  RawClient client(daemon.port());
  EXPECT_EQ(client.call("pattern.get", {{"name", "acme/kept"}})["duration_ms"], 50);
}

}  // namespace
}  // namespace hedgehog::e2e
