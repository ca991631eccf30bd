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
#include <optional>
#include <regex>
#include <string>
#include <utility>
#include <vector>

#include "tests/e2e/daemon_process.h"
#include "tests/e2e/program.h"
#include "tests/e2e/programs.h"
#include "tests/e2e/raw_client.h"
#include "tests/e2e/timeout.h"
#include "tests/e2e/tls_fixture.h"
#include "tests/folders.h"
#include "tests/free_port.h"

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

std::string document(const std::string& name) {
  std::ifstream in(source_folder() + "/systemd/" + name);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// A score in the README, as systemd-analyze's --threshold: "1.5" is 15. `pattern` has a group for
/// each digit. Empty: the README has no such sentence.
std::string documented_threshold(const std::string& pattern) {
  const std::string text = document("README.md");
  std::smatch found;
  return std::regex_search(text, found, std::regex(pattern)) ? found.str(1) + found.str(2) : "";
}

/// The socket unit for clients on other machines.
std::string documented_socket() {
  const std::string text = document("other-machines.md");
  std::smatch found;
  const std::regex block("\\n((    .*\\n|\\n)*    \\[Socket\\]\\n(    .*\\n|\\n)*)");
  if (!std::regex_search(text, found, block)) return "";
  return std::regex_replace(found.str(1), std::regex("(^|\\n)    "), "$1");
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
                                         "hedgehog-gamepad.service", "hedgehog-mqtt.service",
                                         "hedgehog-mqtt@.service"),
                         [](const auto& unit) {
                           const std::string name = unit.param;
                           if (name.starts_with("hedgehog-gamepad")) return "Gamepad";
                           if (name.starts_with("hedgehog-mqtt@")) return "MqttInstance";
                           if (name.starts_with("hedgehog-mqtt")) return "Mqtt";
                           return name.find('@') == std::string::npos ? "Single" : "Instance";
                         });

TEST(SocketUnit, HasOnlyKeysThatSystemdSupports) {
  const Home home;
  const std::string unit = documented_socket();
  ASSERT_THAT(unit, HasSubstr("[Socket]\nListenStream=192.168.7.5:7586\n"));
  home.write("units/hedgehogd.socket", unit);
  home.write("units/hedgehogd.service", "[Service]\nExecStart=" + hedgehogd() + "\n");
  const Output output =
      run("systemd-analyze verify --man=no " + home.path("units/hedgehogd.socket"));
  EXPECT_EQ(output.text, "");
  EXPECT_EQ(output.exit_code, 0);
}

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

class OpenedBySystemd : public testing::Test {
 protected:
  OpenedBySystemd() {
    std::vector<std::string> words{"--listen=" + address(used_), "--listen=" + address(unused_)};
    for (const std::string& variable : home_.environment()) words.push_back("--setenv=" + variable);
    words.insert(words.end(),
                 {hedgehogd(), "--simulate", "--speed", "1", "--listen", address(used_)});
    systemd_.emplace(home_, "/usr/bin/systemd-socket-activate", words);
  }
  static std::string address(int port) { return "127.0.0.1:" + std::to_string(port); }
  bool logs(const std::string& text) {
    return wait_until([&] { return systemd_->err().find(text) != std::string::npos; });
  }

  const Home home_;
  const int used_ = free_port();
  const int unused_ = free_port();
  std::optional<Program> systemd_;
};

TEST_F(OpenedBySystemd, AListenerOfTheConfigurationIsUsed) {
  ASSERT_TRUE(logs("Listening on " + address(unused_))) << systemd_->err();
  RawClient client(used_);  // for which systemd starts the daemon
  EXPECT_EQ(client.call("device.status")["state"], "armed");
  EXPECT_TRUE(systemd_->prints("listening on " + address(used_) + "\n"));
  systemd_->signal(SIGTERM);
  EXPECT_EQ(systemd_->wait().exit_code, 0);
}

TEST_F(OpenedBySystemd, AnotherListenerIsClosedWithAWarning) {
  ASSERT_TRUE(logs("Listening on " + address(unused_))) << systemd_->err();
  RawClient client(unused_);
  EXPECT_TRUE(client.closed_by_daemon());
  EXPECT_TRUE(logs(address(unused_) +
                   ": a socket unit of systemd listens there, but the configuration does not"))
      << systemd_->err();
}

class SocketOfBothFamilies : public TlsFixture {};

TEST_F(SocketOfBothFamilies, IsRefusedWithTheRemedy) {
  const int port = free_port();
  const std::string address = "[::]:" + std::to_string(port);
  std::vector<std::string> words{"--listen=" + address};
  for (const std::string& variable : home_.environment()) words.push_back("--setenv=" + variable);
  words.insert(words.end(), {hedgehogd(), "--simulate", "--listen", address});
  Program systemd(home_, "/usr/bin/systemd-socket-activate", words);
  const std::string listening = "Listening on " + address;
  wait_until([&] { return systemd.err().find("isten") != std::string::npos; });
  if (systemd.err().find(listening) == std::string::npos)
    GTEST_SKIP() << "this machine has no IPv6: " << systemd.err();
  RawClient by_ipv4(port);
  const Ended ended = systemd.wait();
  EXPECT_NE(ended.exit_code, 0);
  EXPECT_THAT(ended.err, HasSubstr("systemd's socket takes IPv4, too"));
}

}  // namespace
}  // namespace hedgehog::e2e
