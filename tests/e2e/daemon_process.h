// SPDX-License-Identifier: MIT
// A real hedgehogd as a process, with folders of its own.
#pragma once

#include <sys/types.h>

#include <csignal>
#include <string>
#include <vector>

#include "tests/temporary_folder.h"

namespace hedgehog::e2e {

/// Runtime, state and configuration of one daemon; outlives its restarts. Removed at the end.
class Home {
 public:
  Home();

  std::string path(const std::string& below) const { return folder_.path(below); }
  std::string state_file() const { return path("state/hedgehog/state.json"); }
  std::string read(const std::string& below) const { return folder_.read(below); }
  void write(const std::string& below, const std::string& text) const {
    folder_.write(below, text);
  }
  /// The daemon's configuration file.
  void configure(const std::string& json) const { write("config/hedgehog/hedgehogd.json", json); }
  /// NAME=VALUE for the children.
  std::vector<std::string> environment() const;

 private:
  TemporaryFolder folder_;
};

struct Ended {
  int exit_code = -1;  // -1: ended by a signal
  std::string out;
  std::string err;
};

/// Runs hedgehogd to its end.
Ended run_daemon(const Home& home, const std::vector<std::string>& arguments);

class DaemonProcess {
 public:
  /// kInStep, also used with any --speed: the simulated ball runs in lock-step with control in real
  /// time, so a busy machine slows everything down and skips nothing. kFree: threads of their own,
  /// as with a real ball, and simulator.process. kConfigured: without --simulate.
  /// --simulate.
  enum class Backend { kInStep, kFree, kConfigured };
  /// Starts hedgehogd on a free port with the arguments `more`, and waits until it listens.
  /// `variables`: NAME=VALUE in addition to the home's.
  explicit DaemonProcess(const Home& home, const std::vector<std::string>& more = {},
                         const std::vector<std::string>& variables = {},
                         Backend backend = Backend::kInStep);
  DaemonProcess(const DaemonProcess&) = delete;
  DaemonProcess& operator=(const DaemonProcess&) = delete;
  /// Kills it if it still runs.
  ~DaemonProcess();

  int port() const noexcept { return port_; }
  /// 0 when HTTP is off.
  int http_port() const noexcept { return http_port_; }
  const std::string& socket() const noexcept { return socket_; }
  pid_t pid() const noexcept { return pid_; }
  void signal(int number) const { ::kill(pid_, number); }
  /// Sends `number` and waits for the end; returns the exit code, -1 when a signal ended it.
  int stop(int number = SIGTERM);
  /// Everything on stderr so far.
  std::string log() const { return home_.read("log"); }
  /// Waits until the log contains `text`.
  bool logs(const std::string& text) const;

 private:
  void end() const;

  const Home& home_;
  pid_t pid_ = -1;
  int port_ = 0;
  int http_port_ = 0;
  std::string socket_;
};

}  // namespace hedgehog::e2e
