// SPDX-License-Identifier: MIT
// A child process: the measured program or a reference program.
#pragma once

#include <sys/types.h>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace hedgehog::bench {

/// One process with its stdin and stdout as pipes. Killed by the destructor. Failures throw
/// std::runtime_error with a sentence.
class Child {
 public:
  /// Starts `words`, found in PATH, with inherited stderr and with `variables`, NAME=VALUE, added
  /// to this environment.
  explicit Child(std::vector<std::string> words, const std::vector<std::string>& variables = {});
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;
  ~Child();

  /// Waits for the next line of stdout that begins with `prefix`; returns the rest of it.
  std::string line_after(std::string_view prefix);
  /// Closes its stdin, and returns what it writes until it exits. The exit code must be 0.
  std::string finish();

  /// Processor time so far of all its threads, s.
  double cpu_s() const;
  /// Processor time of its threads with that name, from the scheduler, s.
  double cpu_s(std::string_view thread) const;
  double resident_kb() const;

 private:
  /// The next line of stdout; nullopt at its end, or after a minute without one.
  std::optional<std::string> line();

  std::string name_;
  pid_t pid_ = -1;
  int in_ = -1;
  int out_ = -1;
  std::string read_;
};

/// The path of an installed program; empty if there is none of that name.
std::string installed(const std::string& program);

}  // namespace hedgehog::bench
