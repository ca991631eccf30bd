// SPDX-License-Identifier: MIT
// Debian's broker and its clients, as processes.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "tests/e2e/program.h"

namespace hedgehog::e2e {

/// mosquitto on a Unix socket in the test's folder. It keeps nothing on disk.
class Mosquitto {
 public:
  /// `more`: lines of its configuration, instead of `allow_anonymous true`. `launcher`: a command
  /// that becomes the program given as its further arguments.
  explicit Mosquitto(const Home& home, std::string more = "allow_anonymous true\n",
                     std::vector<std::string> launcher = {});

  std::string socket() const { return home_.path("broker.sock"); }
  void stop();
  void start();
  pid_t pid() const { return process_->pid(); }
  void signal(int number) const { process_->signal(number); }
  /// Since its last start.
  std::string log() const { return process_->err(); }

 private:
  const Home& home_;
  std::vector<std::string> launcher_;
  std::unique_ptr<Program> process_;
};

/// mosquitto_sub with `filters`: a line for each message, "RETAIN TOPIC PAYLOAD".
class Subscriber {
 public:
  /// Waits until it is subscribed.
  Subscriber(const Home& home, const std::string& socket, const std::vector<std::string>& filters,
             const std::string& format = "%r %t %p");

  /// Waits until a line begins with `text`.
  bool receives(const std::string& text) const;
  /// The number of lines that begin with `text`.
  int count(const std::string& text) const;
  std::string all() const { return program_.out(); }

 private:
  Program program_;
};

/// Runs mosquitto_pub for one message, to its end. `more`: further arguments.
void publish(const Home& home, const std::string& socket, const std::string& topic,
             const std::string& payload, const std::vector<std::string>& more = {});

}  // namespace hedgehog::e2e
