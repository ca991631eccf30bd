// SPDX-License-Identifier: MIT
// Fixture of the tests in the guest: the emulator and the daemon as processes, the guest's clock,
// and the table of figures.
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/types.h>

#include <csignal>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "tests/e2e/daemon_process.h"
#include "tests/e2e/raw_client.h"

namespace hedgehog::vm {

using e2e::Home;
using e2e::Json;
using e2e::RawClient;

/// CLOCK_MONOTONIC of the guest, which counts instructions: it stops while the host is busy.
double now_ms();
/// Polls every `poll_ms` (later on, at least 50 ms) until `done`, for up to `minutes` of the
/// guest's time; false: it was never true.
bool eventually(const std::function<bool()>& done, int poll_ms = 4, int minutes = 1);
/// For programs that read large files of the host, whose duration in the guest is unpredictable.
inline constexpr int kManyMinutes = 5;
void pause_ms(int milliseconds);
/// The output of a shell command, both streams; REQUIRES that it ends by itself.
std::string shell(const std::string& command);

/// From now on the programs under test run from a path that every user can access, wherever the
/// build is.
void open_programs_to_all_users();

/// Adds a line to the table that is printed after the last test.
void figure(const std::string& what, double value, const std::string& unit);

/// A child process; killed at the end if it still runs.
class Child {
 public:
  /// `user`: the user that runs it; empty: root. Its output goes to the file `log`.
  Child(const std::vector<std::string>& words, const std::vector<std::string>& environment,
        const std::string& log, const std::string& user = "");
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;
  ~Child();

  pid_t pid() const noexcept { return pid_; }
  bool ended();
  /// Sends `signal` and waits for the end; returns the exit code, -1 when a signal ended it.
  int stop(int signal = SIGTERM);

 private:
  pid_t pid_ = -1;
};

/// hedgehog-usbip on this guest's ports.
class Emulator {
 public:
  /// `devices`: as on its command line.
  Emulator(const Home& home, std::vector<std::string> devices);

  /// Sends a command; returns the response.
  std::string execute(const std::string& command) const;
  /// Sends a command, and expects "ok".
  void ok(const std::string& command) const { EXPECT_EQ(execute(command), "ok") << command; }
  Json status(const std::string& device) const { return Json::parse(execute("status " + device)); }
  /// Ends it in an orderly way, between two ticks.
  void quit();
  /// The norm of the true currents.
  double current_a() const;
  /// The latest event of that name in the board's trace.
  Json last(const std::string& event) const;

 private:
  const Home& home_;
  std::unique_ptr<Child> child_;
};

/// hedgehogd on real devices, and a client on its Unix socket, with role operate.
class Daemon {
 public:
  /// `variables`: NAME=VALUE in addition to the home's.
  explicit Daemon(const Home& home, const std::string& user = "",
                  const std::vector<std::string>& variables = {});

  RawClient& client() { return *client_; }
  Json call(const std::string& method, const Json& params = Json::object()) {
    return client_->call(method, params);
  }
  Json status() { return call("device.status"); }
  std::string state() { return status()["state"]; }
  bool is(const std::string& state) {
    return eventually([&] { return this->state() == state; }, 20);
  }
  bool logs(const std::string& text) const;
  std::string log() const { return home_.read("log"); }
  /// Arms it as a person would: repeatedly until it is armed.
  void arm();
  /// Plays a pulse upwards that must end as completed; returns the largest current measured by the
  /// board.
  double pulse(const Emulator& emulator, double current_a, int duration_ms);

  int stop(int signal = SIGTERM) { return child_->stop(signal); }
  pid_t pid() const noexcept { return child_->pid(); }

  /// Of the process: open descriptors, private memory in KiB, CPU time in ms.
  int descriptors() const;
  int memory_kib() const;
  double cpu_ms() const;

 private:
  const Home& home_;
  std::unique_ptr<Child> child_;
  std::unique_ptr<RawClient> client_;
};

/// All devices of the emulator, as on its command line.
inline const std::vector<std::string> kEveryDevice{"board,unplugged", "mti,unplugged",
                                                   "hid-sensor,unplugged", "dualsense,unplugged",
                                                   "temper,unplugged"};

/// A home, and the emulator in it with everything unplugged.
class Bench : public testing::Test {
 protected:
  explicit Bench(std::vector<std::string> devices = {"board,unplugged"});
  /// Writes the daemon's configuration: the board by USB, and `more`.
  void configure(const Json& more = Json::object()) const;

  Home home_;
  std::optional<Emulator> emulator_;
};

}  // namespace hedgehog::vm
