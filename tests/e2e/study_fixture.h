// SPDX-License-Identifier: MIT
// hedgehog-study in a folder of its own, with a daemon of its own.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <map>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include "tests/e2e/busy_machine.h"
#include "tests/e2e/daemon_process.h"
#include "tests/e2e/program.h"
#include "tests/e2e/programs.h"
#include "tests/e2e/raw_client.h"
#include "tests/e2e/timeout.h"

namespace hedgehog::e2e {

/// The question of experiment 2 with short circles and few reversals.
inline std::string quick(const std::string& more = "") {
  return R"({"name": "quick", "task": "two_intervals", "level": "current_percent",
             "question": "Which one was stronger?", "start": 100, "ceiling": 200,
             "stages": [{"step_up": 20, "reversals": 3}, {"step_up": 10, "reversals": 3}],
             "step_ratio": 0.5488, "duration_ms": 300, "gap_ms": 200, "practice": 1)" +
         more + "}";
}
/// The question of experiment 1.
inline constexpr const char* kQuickYesNo =
    R"({"name": "quick-yes-no", "task": "yes_no", "level": "current_a", "question": "Felt it?",
        "start": 5, "ceiling": 15, "stages": [{"step_up": 1, "reversals": 5}], "step_ratio": 0.5488,
        "duration_ms": 300, "practice": 0, "catch_one_in": 4})";

class Study : public testing::Test {
 protected:
  Study() {
    home_.write("quick.json", quick());
    home_.write("quick-yes-no.json", kQuickYesNo);
  }
  void start_daemon(int speed = 100) {
    daemon_ = std::make_unique<DaemonProcess>(
        home_, std::vector<std::string>{"--speed", std::to_string(speed)});
  }
  std::vector<std::string> variables() const { return {"HEDGEHOG_ADDRESS=" + address_}; }
  /// The daemon's socket is in the home's runtime directory, also for a daemon started later.
  void store_address() { address_ = daemon_->socket(); }

  std::unique_ptr<Program> begin(std::vector<std::string> words, const std::string& folder = "th") {
    words.insert(words.begin(), {"-C", home_.path(folder)});
    return std::make_unique<Program>(home_, hedgehog_study(), words, variables());
  }
  Ended study(const std::vector<std::string>& words, const std::string& folder = "th") {
    return begin(words, folder)->wait();
  }
  /// Waits for the end of a long program: `Program::wait` alone gives up after ten minutes.
  static Ended wait_long(Program& program) {
    constexpr std::chrono::minutes kWholeStudy{15};
    wait_until([&] { return has_ended(program); }, kWholeStudy);
    return program.wait();
  }
  void plan(const std::string& folder, const std::string& people, const std::string& experiments) {
    Program program(home_, hedgehog_study(),
                    {"plan", home_.path(folder), "--participants", people, "--experiments",
                     experiments, "--seed", "3"});
    const Ended ended = program.wait();
    ASSERT_EQ(ended.exit_code, 0) << ended.err;
  }
  /// The arguments that run it with a person, and with all questions of the check list answered.
  std::vector<std::string> run_quick() const {
    return {"-C",
            home_.path("th"),
            "run",
            "quick",
            "--participant",
            "P01",
            "--experimenter",
            "E1",
            "--consent",
            "014",
            "--age-band",
            "22-29",
            "--dominant-hand",
            "left",
            "--hand-size",
            "18.4",
            "--headphones",
            "--hand-on-top"};
  }
  std::string quick_path() const { return home_.path("quick.json"); }
  std::vector<Json> journal(const std::string& name, const std::string& folder = "th") const {
    std::vector<Json> lines;
    std::istringstream text(home_.read(folder + "/journal/" + name));
    for (std::string line; std::getline(text, line);) {
      const Json parsed = Json::parse(line, nullptr, false);
      if (parsed.is_object()) lines.push_back(parsed);
    }
    return lines;
  }
  std::map<std::string, Json> thresholds(const std::string& folder) {
    std::map<std::string, Json> found;
    for (const Json& run : Json::parse(study({"status", "--json"}, folder).out)) {
      found[run["participant"].get<std::string>() + " " + run["experiment"].get<std::string>()] =
          run["threshold"];
    }
    return found;
  }
  static int count(const std::vector<Json>& lines, const std::string& event) {
    return static_cast<int>(std::count_if(
        lines.begin(), lines.end(), [&](const Json& l) { return l["event"] == event; }));
  }

  Home home_;
  std::unique_ptr<DaemonProcess> daemon_;
  std::string address_;
};

}  // namespace hedgehog::e2e
