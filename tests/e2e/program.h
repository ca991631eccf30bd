// SPDX-License-Identifier: MIT
// The client programs as processes: with their output in files, or on a terminal.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <csignal>
#include <functional>
#include <string>
#include <vector>

#include "tests/e2e/daemon_process.h"
#include "tests/e2e/timeout.h"

namespace hedgehog::e2e {

/// Polls `done` for up to a minute; false if it was never true.
bool eventually(const std::function<bool()>& done);

/// One process, stdin empty. Killed at the end of the test if it still runs.
class Program {
 public:
  /// Starts `path`. `variables`: NAME=VALUE in addition to the home's; the last of a name counts.
  Program(const Home& home, const std::string& path, std::vector<std::string> arguments,
          const std::vector<std::string>& variables = {});
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;
  ~Program();

  pid_t pid() const noexcept { return pid_; }
  void signal(int number) const { ::kill(pid_, number); }
  std::string out() const { return home_.read(out_); }
  std::string err() const { return home_.read(err_); }
  /// Waits until stdout contains `text`.
  bool prints(const std::string& text) const;
  /// Waits for the end. The exit code is -1 when a signal ended it, or this class did after ten
  /// minutes.
  Ended wait();

 private:
  const Home& home_;
  std::string out_;
  std::string err_;
  pid_t pid_ = -1;
};

/// One process on a pseudo terminal of its own, 80 columns and 24 rows.
class TerminalProgram {
 public:
  TerminalProgram(const Home& home, const std::string& path, std::vector<std::string> arguments,
                  const std::vector<std::string>& variables = {});
  TerminalProgram(const TerminalProgram&) = delete;
  TerminalProgram& operator=(const TerminalProgram&) = delete;
  ~TerminalProgram();

  void type(const std::string& keys) const;
  /// As when a person drags the window's corner.
  void resize(int columns, int rows) const;
  void signal(int number) const { ::kill(pid_, number); }
  /// Waits until the output since the start contains `text`; false at the program's end or after
  /// `timeout` without it.
  bool shows(const std::string& text, std::chrono::seconds timeout = kTimeout);
  const std::string& shown() const noexcept { return shown_; }
  /// The terminal echoes input and delivers it line by line, as a shell leaves it.
  bool is_restored() const;
  /// Waits for the end; returns the exit code, -1 when a signal or this class ended it.
  int wait();

 private:
  /// False when no process has the terminal any more.
  bool read_more();

  std::string shown_;
  int terminal_ = -1;
  pid_t pid_ = -1;
};

}  // namespace hedgehog::e2e
