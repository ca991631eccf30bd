// SPDX-License-Identifier: MIT
// Access to uinput: our sysusers files and udev rule, and hedgehog-gamepad as its user.
#include <grp.h>
#include <sys/stat.h>

#include "tests/e2e/programs.h"
#include "tests/folders.h"
#include "tests/vm/gamepad_bench.h"

namespace hedgehog::vm {
namespace {

class GamepadAccess : public GamepadBench {
 protected:
  static void SetUpTestSuite() {
    for (const char* file : {"hedgehog.sysusers", "hedgehog-gamepad.sysusers"})
      shell(std::string("systemd-sysusers " + source_folder() + "/systemd/") + file);
    ASSERT_NE(::getgrnam("hedgehog-gamepad"), nullptr);
    open_programs_to_all_users();
  }
  static void TearDownTestSuite() {
    shell(
        "rm -f /run/udev/rules.d/61-hedgehog-gamepad.rules; udevadm control --reload; "
        "chmod 600 /dev/uinput; chgrp root /dev/uinput");
  }
  static void install_rule() {
    shell("mkdir -p /run/udev/rules.d && cp " + source_folder() +
          "/systemd/61-hedgehog-gamepad.rules /run/udev/rules.d/ && udevadm control --reload && "
          "udevadm trigger --action=add --sysname-match=uinput && udevadm settle");
  }
  /// The user is not in the group that owns the socket of this home.
  std::string tcp_address() const {
    const std::string listening = "listening on ";
    const std::string log = daemon_->log();
    const auto at = log.find(listening + "127.0.0.1:") + listening.size();
    return log.substr(at, log.find('\n', at) - at);
  }
};

TEST_F(GamepadAccess, WithoutTheRuleTheProgramReportsWhatIsMissing) {
  chmod(home_.path("").c_str(), 0777);
  Child bridge({e2e::hedgehog_gamepad()}, home_.environment(), home_.path("bridge"),
               "hedgehog-gamepad");
  EXPECT_TRUE(eventually([&] { return bridge.ended(); }));
  EXPECT_THAT(bridge_log(), testing::HasSubstr("61-hedgehog-gamepad.rules gives it to the group"));
}

TEST_F(GamepadAccess, TheRuleGivesUinputToTheGroupAndTheProgramRunsAsItsUser) {
  install_rule();
  struct stat state {};
  ASSERT_EQ(::stat("/dev/uinput", &state), 0);
  EXPECT_EQ(state.st_gid, ::getgrnam("hedgehog-gamepad")->gr_gid);
  EXPECT_EQ(state.st_mode & 0777, 0660U);
  EXPECT_NE(state.st_gid, ::getgrnam("hedgehog")->gr_gid) << "who plays may make no keyboards";
  chmod(home_.path("").c_str(), 0777);
  begin({"--address", tcp_address()}, "hedgehog-gamepad");
  EXPECT_EQ(shell("stat -c %U /proc/" + std::to_string(bridge_->pid()) + "/status"),
            "hedgehog-gamepad\n");
}

}  // namespace
}  // namespace hedgehog::vm
