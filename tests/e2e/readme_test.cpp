// SPDX-License-Identifier: MIT
// The commands in the README files work exactly as printed.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "tests/e2e/daemon_process.h"
#include "tests/e2e/program.h"
#include "tests/e2e/programs.h"
#include "tests/e2e/raw_client.h"
#include "tests/folders.h"
#include "tests/protocol/example_file.h"

namespace hedgehog::e2e {
namespace {

std::vector<std::string> lines_of(const std::string& file) {
  std::ifstream text(source_folder() + "/" + file);
  std::vector<std::string> lines;
  for (std::string line; std::getline(text, line);) lines.push_back(line);
  return lines;
}

/// Replaces omitted members by "…" in the form of the protocol's examples.
std::string as_example(std::string line) {
  const std::string open = ", …}";
  const auto at = line.find(open);
  return at == std::string::npos ? line : line.replace(at, open.size(), R"(, "…": "…"})");
}

TEST(Readme, TheLinesForNcAreAnsweredAsShown) {
  const Home home;
  DaemonProcess daemon(home);
  RawClient nc(daemon.port());
  std::string response;
  int sent = 0;
  int shown = 0;
  for (const std::string& line : lines_of("README.md")) {
    if (line.rfind("{\"jsonrpc\"", 0) != 0) continue;
    if (line.find("\"method\"") != std::string::npos) {
      nc.send(line + "\n");
      response = nc.response().dump();
      EXPECT_TRUE(Json::parse(response).contains("result")) << line << "\n" << response;
      ++sent;
    } else {
      EXPECT_EQ(protocol::mismatch(as_example(line), response), "") << response;
      ++shown;
    }
  }
  EXPECT_GE(sent, 3);
  EXPECT_GE(shown, 1);
}

TEST(Readme, TheLinesForHedgehogctlRun) {
  const Home home;
  DaemonProcess daemon(home);
  int examples = 0;
  for (const std::string& line : lines_of("README.md")) {
    std::istringstream text(line.substr(0, line.find('#')));
    std::string program;
    std::vector<std::string> words;
    text >> program;
    for (std::string word; text >> word;) words.push_back(word);
    const bool typed = line.rfind("    hedgehogctl ", 0) == 0;
    if (!typed || words.at(0) == "watch")  // watch_test provides a terminal for it
      continue;
    const Ended ended =
        Program(home, hedgehogctl(), words, {"HEDGEHOG_ADDRESS=" + daemon.socket()}).wait();
    EXPECT_EQ(ended.exit_code, 0) << line << "\n" << ended.err;
    ++examples;
  }
  EXPECT_GE(examples, 3);
}

TEST(Readme, AOneShotThroughNcPlays) {
  const Home home;
  if (Program(home, "/bin/sh", {"-c", "nc -h 2>&1 | grep -q -e -N"}).wait().exit_code != 0 &&
      Program(home, "/bin/sh", {"-c", "nc -h 2>&1 | grep -q OpenBSD"}).wait().exit_code != 0)
    FAIL() << "netcat-openbsd is missing: make deps installs it";
  DaemonProcess daemon(home);
  RawClient watcher(daemon.port());
  watcher.call("events.subscribe", {{"scope", "all"}, {"types", {"effect_ended"}}});
  int examples = 0;
  for (std::string line : lines_of("clients/README.md")) {
    const std::string port = " 7586";
    if (line.rfind("echo '{", 0) != 0) continue;
    ASSERT_THAT(line, testing::AllOf(testing::HasSubstr("nc -N"), testing::EndsWith(port)));
    line.replace(line.size() - port.size(), port.size(), " " + std::to_string(daemon.port()));
    const Ended ended = Program(home, "/bin/sh", {"-c", line}).wait();
    EXPECT_EQ(ended.exit_code, 0) << line << "\n" << ended.err;
    const Json felt = watcher.notification("event");
    EXPECT_EQ(felt["reason"], "completed");
    EXPECT_EQ(felt["offset_ns"].get<std::int64_t>() - felt["onset_ns"].get<std::int64_t>(),
              150'000'000);
    ++examples;
  }
  EXPECT_GE(examples, 1);
}

}  // namespace
}  // namespace hedgehog::e2e
