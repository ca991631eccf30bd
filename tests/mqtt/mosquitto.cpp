// SPDX-License-Identifier: MIT
#include "tests/mqtt/mosquitto.h"

#include <gtest/gtest.h>
#include <pwd.h>
#include <unistd.h>

#include <filesystem>
#include <sstream>
#include <utility>

namespace hedgehog::e2e {

namespace {

constexpr const char* kProbe = "listening";

}  // namespace

Mosquitto::Mosquitto(const Home& home, std::string more, std::vector<std::string> launcher)
    : home_(home), launcher_(std::move(launcher)) {
  // Started as root it would switch to a user without write permission here.
  const passwd* user = ::getpwuid(::getuid());
  home_.write("mosquitto.conf", "listener 0 " + socket() + "\npersistence false\n" +
                                    (user != nullptr ? std::string("user ") + user->pw_name : "") +
                                    "\n" + std::move(more));
  start();
}

void Mosquitto::stop() {
  process_->signal(SIGTERM);
  (void)process_->wait();
  process_.reset();
}

void Mosquitto::start() {
  std::filesystem::remove(socket());
  std::vector<std::string> words = launcher_;
  words.insert(words.end(), {"/usr/sbin/mosquitto", "-c", home_.path("mosquitto.conf")});
  process_ = std::make_unique<Program>(home_, words.front(),
                                       std::vector<std::string>(words.begin() + 1, words.end()));
  ASSERT_TRUE(eventually([&] { return std::filesystem::exists(socket()); }));
}

Subscriber::Subscriber(const Home& home, const std::string& socket,
                       const std::vector<std::string>& filters, const std::string& format)
    : program_(home, "/usr/bin/mosquitto_sub", [&] {
        std::vector<std::string> arguments{"--unix", socket, "-V", "5", "-q", "1", "-F", format};
        for (const auto& filter : filters) arguments.insert(arguments.end(), {"-t", filter});
        arguments.insert(arguments.end(), {"-t", kProbe});
        return arguments;
      }()) {
  EXPECT_TRUE(eventually([&] {
    publish(home, socket, kProbe, "yes");
    return program_.out().find(kProbe) != std::string::npos;
  }));
}

bool Subscriber::receives(const std::string& text) const {
  return eventually([&] { return count(text) > 0; });
}

int Subscriber::count(const std::string& text) const {
  std::istringstream lines(program_.out());
  int found = 0;
  for (std::string line; std::getline(lines, line);) found += line.starts_with(text) ? 1 : 0;
  return found;
}

void publish(const Home& home, const std::string& socket, const std::string& topic,
             const std::string& payload, const std::vector<std::string>& more) {
  std::vector<std::string> arguments{"--unix", socket, "-V", "5", "-t", topic, "-m", payload};
  arguments.insert(arguments.end(), more.begin(), more.end());
  Program program(home, "/usr/bin/mosquitto_pub", arguments);
  const Ended ended = program.wait();
  ASSERT_EQ(ended.exit_code, 0) << ended.err;
}

}  // namespace hedgehog::e2e
