// SPDX-License-Identifier: MIT
// The addresses that clients try for the daemon.
#include "clients/lib/address.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <map>

namespace hedgehog::client {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

Environment with(std::map<std::string, std::string> variables) {
  return [variables = std::move(variables)](const std::string& name) {
    const auto found = variables.find(name);
    return found == variables.end() ? std::nullopt : std::optional<std::string>(found->second);
  };
}

std::vector<std::string> places(const std::optional<std::string>& flag, const Environment& env) {
  std::vector<std::string> all;
  for (const Address& address : daemon_addresses(flag, env).value())
    all.push_back(to_string(address));
  return all;
}

TEST(Address, IsReadInEveryCommonNotation) {
  const std::map<std::string, std::string> cases{
      {"127.0.0.1:7586", "127.0.0.1:7586"},
      {"ball-host", "ball-host:7586"},
      {"tcp:ball-host:80", "ball-host:80"},
      {"[::1]:7587", "[::1]:7587"},
      {"[::1]", "[::1]:7586"},
      {"::1", "[::1]:7586"},
      {"/run/hedgehog/hedgehogd.sock", "/run/hedgehog/hedgehogd.sock"},
      {"unix:ball.sock", "ball.sock"},
      {"tls://ball-host", "tls://ball-host:7586"},
      {"tls://[::1]:80", "tls://[::1]:80"},
  };
  for (const auto& [text, expected] : cases) {
    const auto address = parse_address(text);
    ASSERT_TRUE(address.has_value()) << text;
    EXPECT_EQ(to_string(*address), expected);
  }
}

TEST(Address, AnInvalidOneIsNamed) {
  for (const char* text : {"", ":7586", "unix:", "host:", "host:0", "host:65536", "host:75x6",
                           "[::1", "[::1]7586", "tcp:"}) {
    const auto address = parse_address(text);
    ASSERT_FALSE(address.has_value()) << text;
    EXPECT_EQ(address.error().failure, Failure::kBadAddress);
    EXPECT_THAT(address.error().message, HasSubstr("'" + std::string(text) + "'"));
  }
}

TEST(Daemon, IsFirstTriedInItsRuntimeDirectoriesThenOnTcp) {
  EXPECT_THAT(places({}, with({})),
              ElementsAre("/run/hedgehog/hedgehogd.sock",
                          "/tmp/hedgehog-" + std::to_string(getuid()) + "/hedgehogd.sock",
                          "127.0.0.1:7586"));
  EXPECT_THAT(places({}, with({{"XDG_RUNTIME_DIR", "/run/user/7"}})),
              ElementsAre("/run/hedgehog/hedgehogd.sock", "/run/user/7/hedgehog/hedgehogd.sock",
                          "127.0.0.1:7586"));
  EXPECT_THAT(places({}, with({{"RUNTIME_DIRECTORY", "/run/hedgehog-7:/run/other"}})),
              ElementsAre("/run/hedgehog-7/hedgehogd.sock", "/run/hedgehog/hedgehogd.sock",
                          "127.0.0.1:7586"));
  EXPECT_THAT(places({}, with({{"RUNTIME_DIRECTORY", "/run/hedgehog"}})),
              ElementsAre("/run/hedgehog/hedgehogd.sock", "127.0.0.1:7586"));
}

TEST(Daemon, IsOnlyTriedAtTheFlagOrElseAtTheVariable) {
  const auto environment = with({{"HEDGEHOG_ADDRESS", "[::1]:9"}, {"XDG_RUNTIME_DIR", "/run/u"}});
  EXPECT_THAT(places({}, environment), ElementsAre("[::1]:9"));
  EXPECT_THAT(places("/tmp/a.sock", environment), ElementsAre("/tmp/a.sock"));
  EXPECT_THAT(places({}, with({{"HEDGEHOG_ADDRESS", ""}})), testing::SizeIs(3)) << "empty is unset";
}

TEST(Daemon, GetsTheTokenAndIsVerifiedByTheFingerprintOfTheEnvironment) {
  const std::string fingerprint(64, 'a');
  const auto environment = with({{"HEDGEHOG_ADDRESS", "tls://ball-host"},
                                 {"HEDGEHOG_TOKEN", "hht_secret"},
                                 {"HEDGEHOG_FINGERPRINT", fingerprint}});
  const auto remote = daemon_addresses({}, environment).value();
  ASSERT_EQ(remote.size(), 1u);
  EXPECT_TRUE(remote[0].tls);
  EXPECT_EQ(remote[0].token, "hht_secret");
  EXPECT_EQ(remote[0].fingerprint, base::parse_sha256(fingerprint));
  EXPECT_EQ(to_string(remote[0]), "tls://ball-host:7586") << "without the token";
  for (const Address& address :
       daemon_addresses({}, with({{"HEDGEHOG_TOKEN", "hht_secret"}})).value())
    EXPECT_EQ(address.token, "hht_secret");
  const auto wrong = daemon_addresses("tls://ball-host", with({{"HEDGEHOG_FINGERPRINT", "aa:bb"}}));
  ASSERT_FALSE(wrong.has_value());
  EXPECT_EQ(wrong.error().failure, Failure::kBadAddress);
}

TEST(Daemon, IsNotTriedElsewhereWhenTheAddressIsWrong) {
  const auto none = daemon_addresses({}, with({{"HEDGEHOG_ADDRESS", "host:x"}}));
  ASSERT_FALSE(none.has_value());
  EXPECT_EQ(none.error().failure, Failure::kBadAddress);
}

}  // namespace
}  // namespace hedgehog::client
