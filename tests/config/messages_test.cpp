// SPDX-License-Identifier: MIT
// Error messages for a person's mistakes: file, line, key, the allowed and the given value.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "base/keys/json_text.h"
#include "tests/config/fake_files.h"

namespace hedgehog::config {
namespace {

const std::string kFile = "/etc/hedgehog/hedgehogd.json";

std::string wrong(const std::string& text) { return FakeFiles::with(text).errors(); }

TEST(Messages, UnknownKeyWithTheNearestKnownOne) {
  EXPECT_EQ(wrong("{\n  \"limits\": {\n    \"curent_a\": 10\n  }\n}\n"),
            kFile + ":3: limits.curent_a: unknown key; did you mean \"limits.current_a\"?\n");
  EXPECT_EQ(wrong("{\"limit\": {}}"), kFile + ":1: limit: unknown key; did you mean \"limits\"?\n");
  EXPECT_EQ(wrong("{\"ambient_c\": 20}"),
            kFile + ":1: ambient_c: unknown key; did you mean \"simulator.ambient_c\"?\n");
  EXPECT_EQ(wrong("{\"wibbly_wobbly\": 20}"), kFile + ":1: wibbly_wobbly: unknown key\n");
}

TEST(Messages, WrongType) {
  EXPECT_EQ(wrong("{\"output\": {\n\"gain\": \"loud\"}}"),
            kFile + ":2: output.gain: must be a number, 0 to 1, not \"loud\"\n");
  EXPECT_EQ(wrong("{\"simulator\": {\"seed\": 1.5}}"),
            kFile + ":1: simulator.seed: must be a whole number, 0 to 4294967295, not 1.5\n");
  EXPECT_EQ(wrong("{\"simulator\": {\"process\": 1}}"),
            kFile + ":1: simulator.process: must be true or false, not 1\n");
  EXPECT_EQ(wrong("{\"limits\": 10}"), kFile + ":1: limits: must be an object, not 10\n");
  EXPECT_EQ(wrong("{\"backend\": \"bluetooth\"}"),
            kFile + ":1: backend: must be \"simulator\" or \"usb\", not \"bluetooth\"\n");
  EXPECT_EQ(wrong("{\"state_directory\": \"here\"}"),
            kFile + ":1: state_directory: must be an absolute path or null, not \"here\"\n");
  EXPECT_EQ(wrong("[1]"), kFile + ":1: must be an object in braces, not a list\n");
}

TEST(Messages, OutOfRange) {
  EXPECT_EQ(wrong("// mine\n{\n\"limits\":\n{\n\"current_a\": 20}}"),
            kFile + ":5: limits.current_a: must be 0.5 to 15, not 20\n");
  EXPECT_EQ(wrong("{\"telemetry\": {\"max_rate_hz\": 0}}"),
            kFile + ":1: telemetry.max_rate_hz: must be 1 to 200, not 0\n");
}

TEST(Messages, SyntaxErrorsHaveTheLine) {
  EXPECT_EQ(wrong("{\n\"backend\": \"usb\",\n}\n").substr(0, kFile.size() + 20),
            kFile + ":3: not valid JSON: ");
  EXPECT_EQ(wrong("").substr(0, kFile.size() + 20), kFile + ":1: not valid JSON: ");
  EXPECT_EQ(wrong("{\n\n\"output\": {\"gain\": 1e999}}").substr(0, kFile.size() + 20),
            kFile + ":3: not valid JSON: ");
  EXPECT_EQ(wrong("{\"a\":\n" + std::string(40, '[')), kFile + ":2: more than 16 levels deep\n");
  EXPECT_EQ(wrong(std::string((1u << 20) + 1, ' ')), kFile + ": is larger than 1 MiB\n");
}

TEST(Messages, ANulEndsNoFile) {
  using namespace std::string_literals;
  const std::string why = ": not valid JSON: has a NUL byte, which JSON never has\n";
  EXPECT_EQ(wrong("{}\n\0garbage"s), kFile + ":2" + why);
  EXPECT_EQ(wrong("// mine\0 {\n{}\n"s), kFile + ":1" + why) << "nor a comment";
}

TEST(Messages, AKeyGivenTwice) {
  EXPECT_EQ(wrong("{\"log\": {\"level\": \"info\",\n\"level\": \"debug\"}}"),
            kFile + ":2: log.level: given twice\n");
}

TEST(Messages, AllAtOnceInTheOrderOfTheFile) {
  EXPECT_EQ(wrong("{\n\"backend\": 1,\n\"bakend\": 2,\n\"output\": {\"gain\": 3}\n}"),
            kFile + ":2: backend: must be \"simulator\" or \"usb\", not 1\n" + kFile +
                ":3: bakend: unknown key; did you mean \"backend\"?\n" + kFile +
                ":4: output.gain: must be 0 to 1, not 3\n");
}

TEST(Messages, LimitsOnlyTighten) {
  FakeFiles fake = FakeFiles::with("{\"device\": \"mine\",\n\"limits\": {\"current_a\": 11}}");
  fake.files[kDeviceFile] = R"({"limits": {"current_a": 10}})";
  EXPECT_EQ(fake.errors(), kFile + ":2: limits.current_a: must be at most 10, the limit in the " +
                               "device file, not 11: configuration only tightens\n");
  fake.files[kFile] = R"({"device": "mine", "limits": {"current_a": 9}})";
  EXPECT_EQ(fake.load()->limits.current_a, 9);
  EXPECT_EQ(fake.load()->device.limits.current_a, 10);
}

TEST(Messages, ALowerMaximumLowersTheContinuousCurrentToo) {
  const auto config = FakeFiles::with(R"({"limits": {"current_a": 2}})").load();
  ASSERT_TRUE(config.has_value());
  EXPECT_EQ(config->limits.continuous_a, 2);
  EXPECT_EQ(config->limits.felt_a, 2);
}

TEST(Messages, LimitsStayInOrder) {
  EXPECT_EQ(wrong("{\"limits\": {\n\"trip_c\": 65}}"),
            kFile + ":2: limits.trip_c: must be above limits.zero_c (69), not 65\n");
  EXPECT_EQ(wrong("{\"limits\": {\"current_a\": 3,\n\"continuous_a\": 4}}"),
            kFile + ":2: limits.continuous_a: must be at most limits.current_a (3), not 4\n");
  EXPECT_EQ(
      wrong_device("{\"limits\":\n{\"sustain_c\": 50}}"),
      kDeviceFile + ":2: limits.sustain_c: must be above limits.derate_from_c (60), not 50\n");
}

TEST(Messages, OneAddressHasOneListener) {
  EXPECT_EQ(wrong(R"({"http": {"listen": "127.0.0.1:7586"}})"),
            kFile + ":1: http.listen: 127.0.0.1:7586 is in listen.tcp too: take another port\n");
  EXPECT_EQ(wrong(R"({"http": {"listen": "127.0.0.1:0"}, "listen": {"tcp": ["127.0.0.1:0"]}})"),
            "");
}

TEST(Messages, ListenersDoNotOverlap) {
  EXPECT_EQ(wrong(R"({"listen": {"tcp": ["127.0.0.1:7586", "127.0.0.1:7586"]}})"),
            kFile + ":1: listen.tcp: \"127.0.0.1:7586\" is given twice\n");
  EXPECT_EQ(wrong(R"({"listen": {"tcp": ["127.0.0.1:7586", "0.0.0.0:7586"]}})"),
            kFile +
                ":1: listen.tcp: \"0.0.0.0:7586\" and 127.0.0.1:7586 overlap: name single "
                "addresses, or take another port\n");
  EXPECT_EQ(wrong(R"({"listen": {"tcp": ["[::1]:7586", "[0::1]:7586"]}})"),
            kFile + ":1: listen.tcp: \"[0::1]:7586\" is given twice\n");
  EXPECT_EQ(wrong(R"({"listen": {"tcp": ["[::1]:7586", "tls://[0::]:7586"]}})"),
            kFile +
                ":1: listen.tcp: \"tls://[0::]:7586\" and [::1]:7586 overlap: name single "
                "addresses, or take another port\n");
  EXPECT_THAT(
      wrong(R"({"http": {"listen": "0.0.0.0:7586"}})"),
      testing::HasSubstr(kFile + ":1: http.listen: tls://0.0.0.0:7586 and 127.0.0.1:7586 of "
                                 "listen.tcp overlap: take another port\n"));
  EXPECT_EQ(wrong(R"({"listen": {"tcp": ["127.0.0.1:7586", "127.0.0.2:7586", "[::1]:7586"]}})"), "")
      << "other addresses, and the other family";
}

TEST(Messages, AddressesHaveAFormat) {
  const std::string shape = "must be an address and a port, such as 127.0.0.1:7586 or [::1]:7586\n";
  for (const std::string address :
       {"7586", "localhost:7586", "127.0.0.1", "127.0.0.1:", "::1:7586", "[::1]", "127.0.0.1:7 "}) {
    EXPECT_EQ(wrong("{\"http\": {\"listen\": \"" + address + "\"}}"),
              kFile + ":1: http.listen: \"" + address + "\": " + shape);
  }
  EXPECT_EQ(wrong("{\"listen\": {\"tcp\": [\"[::1]:70000\"]}}"),
            kFile + ":1: listen.tcp: \"[::1]:70000\": the port must be 0 to 65535\n");
}

TEST(Messages, AListenerIsRequired) {
  EXPECT_EQ(wrong("{\"listen\": {\"tcp\": [], \"unix\": null}}"),
            kFile + ":1: listen.tcp: the daemon would have no listener: listen.unix is null too\n");
  EXPECT_EQ(wrong("{\"listen\": {\"tcp\": []}}"), "");
}

TEST(Messages, ASimulatedImuOnARealBallIsRefused) {
  EXPECT_EQ(wrong("{\"backend\": \"usb\",\n\"imu\": {\"type\": \"simulator\"}}"),
            kFile + ":2: imu.type: \"simulator\" goes with backend \"simulator\" only\n");
}

TEST(Messages, OriginsHaveNoPath) {
  for (const std::string origin : {"*", "game.example", "https://", "https://a/b", "https://*.a"}) {
    EXPECT_EQ(wrong("{\"http\": {\"allow_origins\": [\"" + origin + "\"]}}"),
              kFile + ":1: http.allow_origins: must be a list of origins such as " +
                  "\"https://example.org\", without a path or \"*\", not \"" + origin + "\"\n");
  }
}

TEST(Messages, LinesAreCountedRightAfterNumbersAndComments) {
  const auto root =
      keys::parse_json("{ /* a\nb */ \"a\": 1\n,\"b\": [1,\n2\n,3],\n\"c\": true\n}", "f");
  ASSERT_TRUE(root.has_value());
  EXPECT_EQ(root->elements[0].line, 2);
  EXPECT_EQ(root->elements[1].line, 3);
  EXPECT_EQ(root->elements[1].elements[1].line, 4);
  EXPECT_EQ(root->elements[1].elements[2].line, 5);
  EXPECT_EQ(root->elements[2].line, 6);
}

}  // namespace
}  // namespace hedgehog::config
