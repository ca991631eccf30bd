// SPDX-License-Identifier: MIT
// The units as systemd parses them, and the daemon's notifications to systemd.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <regex>
#include <string>
#include <utility>

#include "tests/e2e/daemon_process.h"
#include "tests/e2e/programs.h"
#include "tests/e2e/raw_client.h"
#include "tests/e2e/timeout.h"
#include "tests/folders.h"

namespace hedgehog::e2e {
namespace {

using std::string_literals::operator""s;
using testing::HasSubstr;

struct Output {
  int exit_code = -1;
  std::string text;
};

Output run(const std::string& command) {
  Output output;
  std::FILE* pipe = ::popen((command + " 2>&1").c_str(), "r");
  std::array<char, 4096> buffer{};
  for (std::size_t n = 0; (n = std::fread(buffer.data(), 1, buffer.size(), pipe)) > 0;)
    output.text.append(buffer.data(), n);
  output.exit_code = WEXITSTATUS(::pclose(pipe));
  return output;
}

std::string readme() {
  std::ifstream in(source_folder() + "/systemd/README.md");
  return {std::istreambuf_iterator<char>(in), {}};
}

/// A score in the README, as systemd-analyze's --threshold: "1.5" is 15. `pattern` has a group for
/// each digit. Empty: the README has no such sentence.
std::string documented_threshold(const std::string& pattern) {
  const std::string text = readme();
  std::smatch found;
  return std::regex_search(text, found, std::regex(pattern)) ? found.str(1) + found.str(2) : "";
}

/// The README's drop-in for clients on other machines.
std::string documented_drop_in() {
  const std::string text = readme();
  std::smatch found;
  const std::regex block("\\n    (\\[Service\\]\\n)    (IPAddressAllow=.*\\n)");
  return std::regex_search(text, found, block) ? found.str(1) + found.str(2) : "";
}

class Unit : public testing::TestWithParam<const char*> {
 protected:
  /// A copy whose ExecStart is the program under test.
  std::string installed() {
    const std::string name = GetParam();
    std::ifstream in(source_folder() + "/systemd/" + name);
    std::string text{std::istreambuf_iterator<char>(in), {}};
    for (const auto& [program, built] :
         {std::pair("/usr/bin/hedgehogd"s, hedgehogd()),
          std::pair("/usr/bin/hedgehog-gamepad"s, hedgehog_gamepad()),
          std::pair("/usr/bin/hedgehog-mqtt"s, hedgehog_mqtt())})
      for (auto at = text.find(program); at != std::string::npos; at = text.find(program, at + 1))
        text.replace(at, program.size(), built);
    home_.write("units/" + name, text);
    std::string unit = name;
    if (const auto at = unit.find("@."); at != std::string::npos) unit.insert(at + 1, "ball-7");
    return home_.path("units/" + unit);
  }
  Home home_;
};

// systemd-analyze prints a warning for an unknown key and still exits with 0, so any output is a
// failure.
TEST_P(Unit, HasOnlyKeysThatSystemdSupports) {
  const Output output = run("systemd-analyze verify --man=no " + installed());
  EXPECT_EQ(output.text, "");
  EXPECT_EQ(output.exit_code, 0);
}

TEST_P(Unit, IsHardened) {
  const std::string threshold = documented_threshold("a score of (\\d)\\.(\\d) or better");
  const Output output =
      run("systemd-analyze security --offline=yes --threshold=" + threshold + " " + installed());
  EXPECT_EQ(output.exit_code, 0) << output.text;
}

INSTANTIATE_TEST_SUITE_P(Systemd, Unit,
                         testing::Values("hedgehogd.service", "hedgehogd@.service",
                                         "hedgehog-gamepad.service", "hedgehog-mqtt.service"),
                         [](const auto& unit) {
                           const std::string name = unit.param;
                           if (name.starts_with("hedgehog-gamepad")) return "Gamepad";
                           if (name.starts_with("hedgehog-mqtt")) return "Mqtt";
                           return name.find('@') == std::string::npos ? "Single" : "Instance";
                         });

class DaemonUnit : public Unit {};

TEST_P(DaemonUnit, IsHardenedForRemoteAccess) {
  home_.write("units/"s + GetParam() + ".d/override.conf", documented_drop_in());
  const std::string threshold = documented_threshold("(\\d)\\.(\\d) with the drop-in");
  const std::string unit = installed();
  const Output output =
      run("systemd-analyze security --offline=yes --threshold=" + threshold + " " + unit);
  EXPECT_EQ(output.exit_code, 0) << output.text;
  EXPECT_THAT(output.text, HasSubstr("allow list with non-localhost entries"));
  EXPECT_EQ(run("systemd-analyze verify --man=no " + unit).text, "");
}

INSTANTIATE_TEST_SUITE_P(Systemd, DaemonUnit,
                         testing::Values("hedgehogd.service", "hedgehogd@.service"),
                         [](const auto& unit) {
                           return unit.param == "hedgehogd.service"s ? "Single" : "Instance";
                         });

/// systemd's side of sd_notify.
class NotifySocket {
 public:
  explicit NotifySocket(const std::string& path)
      : fd_(::socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC, 0)) {
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    path.copy(address.sun_path, sizeof address.sun_path - 1);
    EXPECT_EQ(::bind(fd_, reinterpret_cast<sockaddr*>(&address), sizeof address), 0);
    const timeval timeout{kTimeout.count(), 0};
    ::setsockopt(fd_, SOL_SOCKET, SO_RCVTIMEO, &timeout, sizeof timeout);
  }
  ~NotifySocket() { ::close(fd_); }

  /// Waits for a message that contains `word`.
  std::string wait_for(const std::string& word) {
    for (;;) {
      std::array<char, 4096> buffer{};
      const ssize_t count = ::recv(fd_, buffer.data(), buffer.size(), 0);
      if (count <= 0) return {};
      std::string text(buffer.data(), static_cast<std::size_t>(count));
      if (text.find(word) != std::string::npos) return text;
    }
  }

 private:
  int fd_;
};

TEST(Systemd, IsNotifiedOfReadinessStatusReloadsWatchdogAndTheEnd) {
  const Home home;
  NotifySocket systemd(home.path("notify"));
  DaemonProcess daemon(home, {}, {"NOTIFY_SOCKET=" + home.path("notify"), "WATCHDOG_USEC=4000000"});
  EXPECT_NE(systemd.wait_for("READY=1").find("STATUS=SIMULATOR: armed"), std::string::npos);
  EXPECT_NE(systemd.wait_for("WATCHDOG=1"), "");
  RawClient(daemon.port()).call("device.emergency_stop");
  EXPECT_NE(systemd.wait_for("emergency_stop"), "");
  daemon.signal(SIGHUP);
  EXPECT_NE(systemd.wait_for("RELOADING=1").find("MONOTONIC_USEC="), std::string::npos);
  EXPECT_NE(systemd.wait_for("READY=1"), "");
  daemon.signal(SIGTERM);
  EXPECT_NE(systemd.wait_for("STOPPING=1"), "");
}

}  // namespace
}  // namespace hedgehog::e2e
