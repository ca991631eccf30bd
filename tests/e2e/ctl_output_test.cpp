// SPDX-License-Identifier: MIT
// Output of hedgehogctl to scripts, pipes and monitoring systems.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "tests/e2e/daemon_process.h"
#include "tests/e2e/exit_codes.h"
#include "tests/e2e/program.h"
#include "tests/e2e/programs.h"
#include "tests/e2e/raw_client.h"

namespace hedgehog::e2e {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

class CtlOutput : public testing::Test {
 protected:
  Ended ctl(const std::vector<std::string>& arguments,
            std::vector<std::string> variables = {}) const {
    variables.push_back("HEDGEHOG_ADDRESS=" + daemon_.socket());
    return Program(home_, hedgehogctl(), arguments, variables).wait();
  }

  Home home_;
  DaemonProcess daemon_{home_};
  RawClient other_{daemon_.port()};
};

TEST_F(CtlOutput, ErrorsAreJsonForPrograms) {
  const Ended refused = ctl({"--json", "pulse", "99"});
  EXPECT_EQ(refused.exit_code, kUsage);
  EXPECT_THAT(refused.out, IsEmpty());
  const Json error = Json::parse(refused.err)["error"];
  EXPECT_EQ(error["code"], -32602);
  EXPECT_EQ(error["data"]["name"], "invalid_params");
  EXPECT_EQ(error["data"]["limit"], 85);
  const Ended wrong = ctl({"pulse", "left", "--loud", "3", "--json"});
  EXPECT_EQ(wrong.exit_code, kUsage);
  EXPECT_EQ(Json::parse(wrong.err)["error"]["data"]["name"], "usage");
  EXPECT_THAT(Json::parse(wrong.err)["error"]["message"].get<std::string>(), HasSubstr("--loud"));
}

TEST_F(CtlOutput, AGainHasAllItsDigits) {
  EXPECT_EQ(Json::parse(ctl({"gain", "0.0042", "--json"}).out)["gain"], 0.0042);
  EXPECT_EQ(Json::parse(ctl({"gain", "--json"}).out)["gain"], 0.0042);
  EXPECT_THAT(ctl({"gain"}).out, HasSubstr("gain 0.0042:"));
}

TEST_F(CtlOutput, InvalidUtf8IsAUsageError) {
  for (const std::vector<std::string>& words : {std::vector<std::string>{"pulse", "\xff"},
                                                {"play", "\xff"},
                                                {"forecast", "5", "\xff"},
                                                {"pulse", "left", "--slot", "\xff"},
                                                {"pulse", "left", "--current-a", "\xff"}}) {
    std::vector<std::string> as_json = words;
    as_json.emplace_back("--json");
    const Ended ended = ctl(as_json);
    EXPECT_EQ(ended.exit_code, kUsage) << words.front() << words.back();
    EXPECT_THAT(ended.err, HasSubstr("\"name\":\"usage\"")) << words.back();
    EXPECT_THAT(ended.err, HasSubstr("is not UTF-8"));
  }
}

TEST_F(CtlOutput, OnlyJsonIsOnStdoutWhenTheDaemonEnds) {
  Program hold(home_, hedgehogctl(), {"hold", "up", "--json"},
               {"HEDGEHOG_ADDRESS=" + daemon_.socket()});
  ASSERT_TRUE(hold.prints("accepted"));
  daemon_.stop(SIGKILL);
  const Ended ended = hold.wait();
  EXPECT_EQ(ended.exit_code, kUnavailable);
  EXPECT_EQ(Json::parse(ended.err)["error"]["data"]["name"], "closed");
  std::istringstream lines(ended.out);
  for (std::string line; std::getline(lines, line);) EXPECT_TRUE(Json::accept(line)) << line;
}

TEST_F(CtlOutput, ErrorsNameTheNearestValidWord) {
  const std::vector<std::pair<std::vector<std::string>, const char*>> usage_errors{
      {{"statsu"}, "there is no verb 'statsu'; did you mean 'status'?"},
      {{"preview", "pulze", "left"}, "there is no verb 'pulze'; did you mean 'pulse'?"},
      {{"patterns", "improt", "x.ahap"}, "there is no verb 'improt'; did you mean 'import'?"},
      {{"pulse", "left", "--duration", "3"}, "did you mean '--duration-ms'?"},
      {{"play"}, "pattern or --keyframes is required"},
      {{"play", "--keyframes", "{"}, "keyframes: is not JSON"},
      {{"forecast", "left"}, "'left' is no current in ampere; a direction comes after it"},
  };
  for (const auto& [words, error_message] : usage_errors) {
    const Ended ended = ctl(words);
    EXPECT_EQ(ended.exit_code, kUsage) << error_message;
    EXPECT_THAT(ended.err, HasSubstr(error_message));
  }
}

TEST_F(CtlOutput, AMissingPatternIsExitCode66) {
  const Ended missing = ctl({"play", "nope"});
  EXPECT_EQ(missing.exit_code, kNoInput);
  EXPECT_THAT(missing.err, HasSubstr("nope"));
  EXPECT_EQ(ctl({"patterns", "get", "nope"}).exit_code, kNoInput);
  EXPECT_EQ(ctl({"play", "nope.json"}).exit_code, kNoInput);
}

TEST_F(CtlOutput, CheckHasExitCodesOfItsOwnAndIsJsonForPrograms) {
  const Ended help = ctl({"check", "--help"});
  EXPECT_EQ(help.exit_code, 0);
  EXPECT_THAT(help.out, HasSubstr("0 ok, 1 warning, 2 critical, 3 unknown"));
  EXPECT_THAT(help.out, Not(HasSubstr("64 usage")));
  const Ended wrong = ctl({"check", "--lout"});
  EXPECT_EQ(wrong.exit_code, 3);
  EXPECT_THAT(wrong.out, testing::StartsWith("HEDGEHOG UNKNOWN - "));
  EXPECT_THAT(wrong.out, HasSubstr("unknown option '--lout'"));
  ctl({"stop"});
  const Ended stopped = ctl({"check", "--json"});
  EXPECT_EQ(stopped.exit_code, 1);
  const Json json = Json::parse(stopped.out);
  EXPECT_EQ(json["code"], 1);
  EXPECT_EQ(json["state"], "WARNING");
  EXPECT_THAT(json["message"].get<std::string>(), HasSubstr("disarmed: emergency_stop"));
  EXPECT_EQ(json["measures"]["limit"]["value"], 0);
  ctl({"arm"});
  const Ended usage_error = ctl({"check", "--json", "--lout"});
  EXPECT_EQ(usage_error.exit_code, 3);
  EXPECT_EQ(Json::parse(usage_error.out)["state"], "UNKNOWN");
  daemon_.stop();
  const Ended without_daemon = ctl({"check", "--json"});
  EXPECT_EQ(without_daemon.exit_code, 2);
  EXPECT_EQ(Json::parse(without_daemon.out)["state"], "CRITICAL");
  EXPECT_THAT(Json::parse(without_daemon.out)["message"].get<std::string>(),
              HasSubstr("no daemon answers"));
}

TEST_F(CtlOutput, NothingIsTruncatedInAPipe) {
  const std::string name = "A game with a name of more than twenty characters";
  other_.call("hello", {{"client", name}});
  EXPECT_THAT(ctl({"clients"}).out, HasSubstr(name + "  tcp "));
  const std::string patterns = ctl({"patterns"}).out;
  EXPECT_THAT(patterns, Not(HasSubstr("…")));
  const Json listed = Json::parse(ctl({"patterns", "--json"}).out)["patterns"];
  for (const Json& pattern : listed)
    EXPECT_THAT(patterns, HasSubstr(pattern["description"].get<std::string>() + "\n"));
}

TEST_F(CtlOutput, WithoutUtf8AllIsAscii) {
  other_.call("sim.set", {{"orientation", {{"w", 0.9}, {"x", 0.3}, {"y", 0.3}, {"z", 0}}}});
  for (const char* verb : {"status", "forecast", "arm", "trips", "devices", "pins"}) {
    const Ended ended = ctl({verb}, {"LC_ALL=C"});
    EXPECT_EQ(ended.exit_code, 0) << ended.err;
    for (const char byte : ended.out)
      ASSERT_LT(static_cast<unsigned char>(byte), 0x80) << ended.out;
  }
}

}  // namespace
}  // namespace hedgehog::e2e
