// SPDX-License-Identifier: MIT
// Roles by the user of the Unix socket: a real daemon, and clients of other users. Needs root to
// change the user.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "tests/e2e/daemon_process.h"
#include "tests/e2e/exit_codes.h"
#include "tests/e2e/other_user.h"
#include "tests/e2e/program.h"
#include "tests/e2e/programs.h"
#include "tests/e2e/raw_client.h"

namespace hedgehog::e2e {
namespace {

using testing::HasSubstr;

constexpr int kNoRole = -32003;
constexpr int kRoleIsTooLow = -32004;
const Json kTenSeconds{{"direction", "left"}, {"duration_ms", 10'000}};

std::string unix_lists(const std::string& lists) {
  return "{\"access\": {\"unix\": {" + lists + "}}}";
}

mode_t mode_of(const std::string& path) {
  struct stat s {};
  return ::stat(path.c_str(), &s) == 0 ? s.st_mode & 0777 : 0;
}

class LocalUsers : public testing::Test {
 protected:
  void SetUp() override {
    if (::geteuid() != 0) GTEST_SKIP() << "only root can be other users";
    start(R"("operate": ["bin"], "play": ["@users"])");
  }
  void start(const std::string& lists) {
    daemon_.reset();
    home_.configure(unix_lists(lists));
    daemon_ = std::make_unique<DaemonProcess>(home_);
    open_to_all_users(home_);
  }
  void reload(const std::string& lists) {
    home_.configure(unix_lists(lists));
    daemon_->signal(SIGHUP);
    ASSERT_TRUE(daemon_->logs("configuration reloaded"));
  }
  std::unique_ptr<RawClient> client_of(uid_t user, const std::vector<gid_t>& groups = {}) {
    const OtherUser other(user, groups);
    return std::make_unique<RawClient>(daemon_->socket());
  }
  /// hedgehogctl as a process of that user.
  Ended ctl_of(uid_t user, const std::string& groups, std::vector<std::string> words,
               const std::vector<std::string>& variables = {}) {
    const std::string program = home_.path("hedgehogctl");
    std::filesystem::copy_file(hedgehogctl(), program,
                               std::filesystem::copy_options::skip_existing);
    words.insert(words.begin(),
                 {"--reuid=" + std::to_string(user), "--regid=nogroup", groups, program});
    return Program(home_, "/usr/bin/setpriv", words, variables).wait();
  }
  double current_a() {
    RawClient root(daemon_->socket());
    const Json currents = root.call("device.status")["current_a"];
    double max_a = 0.0;
    for (const Json& current : currents) max_a = std::max(max_a, std::abs(current.get<double>()));
    return max_a;
  }

  Home home_;
  std::unique_ptr<DaemonProcess> daemon_;
};

TEST_F(LocalUsers, HaveTheRoleOfTheirListAndOthersNone) {
  EXPECT_EQ(mode_of(daemon_->socket()), 0666u);
  EXPECT_EQ(client_of(0)->call("hello")["role"], "operate");
  EXPECT_EQ(client_of(kBinUser)->call("hello")["role"], "operate");
  const auto player = client_of(kGamesUser, {kUsersGroup});
  EXPECT_EQ(player->call("hello")["role"], "play") << "by a supplementary group";
  EXPECT_TRUE(player->call("effect.pulse", kTenSeconds)["accepted"]);
  EXPECT_EQ(player->call("output.set_gain", {{"gain", 0.5}})["code"], kRoleIsTooLow);
  const auto without_role = client_of(kGamesUser);
  EXPECT_EQ(without_role->call("hello")["code"], kNoRole) << "the same user without the group";
}

TEST_F(LocalUsers, WithoutARoleDriveNoCurrentAndGetTheReason) {
  const auto without_role = client_of(kNobodyUser);
  for (const std::string method : {"effect.pulse", "effect.hold", "effect.vibrate"}) {
    const Json error = without_role->call(method, {{"direction", "left"}});
    EXPECT_EQ(error["code"], kNoRole) << method;
    EXPECT_THAT(std::string(error["message"]), HasSubstr("user 65534 has no role"));
  }
  EXPECT_EQ(without_role->call("device.emergency_stop")["code"], kNoRole);
  EXPECT_LT(current_a(), 0.1);
  EXPECT_EQ(client_of(0)->call("device.status")["state"], "armed");
  // The same request by a user with the role, so that this test can fail.
  const auto player = client_of(kGamesUser, {kUsersGroup});
  ASSERT_TRUE(player->call("effect.pulse", kTenSeconds)["accepted"]);
  EXPECT_TRUE(eventually([&] { return current_a() > 1.0; }));
}

TEST_F(LocalUsers, WithoutARoleGetTheirExitCodeAndMaySendAToken) {
  const std::vector<std::string> push{"pulse", "left"};
  EXPECT_EQ(ctl_of(kGamesUser, "--groups=users", push).exit_code, 0);
  const Ended refused = ctl_of(kNobodyUser, "--clear-groups", push);
  EXPECT_EQ(refused.exit_code, 77);
  EXPECT_THAT(refused.err, HasSubstr("user 65534 has no role in access.unix"));
  const std::string made =
      Program(home_, hedgehogctl(),
              {"token", "add", "guest", "--role", "play", "--state", home_.path("state/hedgehog")})
          .wait()
          .out;
  daemon_->signal(SIGHUP);
  ASSERT_TRUE(daemon_->logs("configuration reloaded"));
  const std::string token = made.substr(0, made.find('\n'));
  EXPECT_EQ(ctl_of(kNobodyUser, "--clear-groups", push, {"HEDGEHOG_TOKEN=" + token}).exit_code, 0);
  EXPECT_THAT(daemon_->log(), HasSubstr("the token guest gives unix (user 65534, process "));
}

TEST_F(LocalUsers, AreNamedInTheListAndTheLog) {
  const auto player = client_of(kGamesUser, {kUsersGroup});
  ASSERT_EQ(player->call("hello", {{"client", "racer"}})["role"], "play");
  EXPECT_EQ(player->call("connection.list")["code"], kRoleIsTooLow);
  const Json listed = client_of(kBinUser)->call("connection.list")["connections"][0];
  EXPECT_EQ(listed["uid"], kGamesUser);
  EXPECT_EQ(listed["pid"], ::getpid());
  EXPECT_TRUE(
      daemon_->logs("connection 1 from unix (user 5, process " + std::to_string(::getpid()) + ")"));
  const std::string shown = Program(home_, hedgehogctl(), {"clients"}).wait().out;
  EXPECT_THAT(shown,
              testing::ContainsRegex("racer +unix +5 +" + std::to_string(::getpid()) + " +play"));
}

TEST_F(LocalUsers, AReloadThatChangesTheirRoleEndsConnectionsAndEffects) {
  const auto player = client_of(kGamesUser, {kUsersGroup});
  const auto owner = client_of(kBinUser);
  ASSERT_EQ(owner->call("hello")["role"], "operate");
  ASSERT_TRUE(player->call("effect.pulse", kTenSeconds)["accepted"]);
  ASSERT_TRUE(eventually([&] { return current_a() > 1.0; }));
  reload(R"("operate": ["bin"])");
  EXPECT_TRUE(player->closed_by_daemon());
  EXPECT_TRUE(eventually([&] { return current_a() < 0.1; }));
  EXPECT_TRUE(owner->call("ping").contains("time_ns"));
  EXPECT_EQ(client_of(kGamesUser, {kUsersGroup})->call("hello")["code"], kNoRole);
}

TEST_F(LocalUsers, AllowedByAListDoNotOperateAfterAReloadThatAllowsAllUsers) {
  const auto without_role = client_of(kNobodyUser);
  ASSERT_EQ(without_role->call("hello")["code"], kNoRole);
  reload(R"("operate": ["*"])");
  EXPECT_TRUE(daemon_->logs("at the next start only: access.unix.operate"));
  EXPECT_EQ(without_role->call("hello")["code"], kNoRole);
  EXPECT_EQ(client_of(kNobodyUser)->call("hello")["code"], kNoRole);
  start(R"("operate": ["*"])");
  EXPECT_EQ(mode_of(daemon_->socket()), 0660u);
  EXPECT_THROW(client_of(kNobodyUser), std::runtime_error) << "the socket's group decides again";
  reload(R"("operate": ["bin"], "observe": ["*"])");
  EXPECT_EQ(client_of(kNobodyUser)->call("hello")["role"], "observe");
}

TEST_F(LocalUsers, WithoutARoleDoNotBlockTheEmergencyStop) {
  std::vector<std::unique_ptr<RawClient>> clients;
  constexpr int kClients = 100;
  clients.reserve(kClients);
  for (int i = 0; i < kClients; ++i) clients.push_back(client_of(kNobodyUser));
  EXPECT_TRUE(clients.front()->closed_by_daemon()) << "the oldest lost its place";
  EXPECT_FALSE(client_of(kBinUser)->call("device.emergency_stop").contains("code"));
}

TEST(LocalUsersConfiguration, AnUnknownNameIsRefusedWithItsLine) {
  const Home home;
  home.configure("{\"access\": {\"unix\": {\n\"operate\": [\"@no-such-group-here\"]}}}");
  const Ended ended = run_daemon(home, {"--check-config"});
  EXPECT_EQ(ended.exit_code, kConfig);
  EXPECT_THAT(ended.err, HasSubstr(":2: access.unix.operate: \"@no-such-group-here\": there is no "
                                   "such group"));
}

}  // namespace
}  // namespace hedgehog::e2e
