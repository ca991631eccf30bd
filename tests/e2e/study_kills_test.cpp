// SPDX-License-Identifier: MIT
// A whole study, rehearsed twice: once undisturbed, once with runner and daemon killed repeatedly.
// Both give the same results, trial by trial.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <random>
#include <thread>

#include "tests/e2e/busy_machine.h"
#include "tests/e2e/study_fixture.h"
#include "tests/folders.h"

namespace hedgehog::e2e {
namespace {

namespace fs = std::filesystem;

struct Scale {
  std::string people;
  std::vector<std::string> experiments;
  int kills;
  int longest_ms;  // between two kills
};

class Kills : public Study {
 protected:
  /// HEDGEHOG_STUDY_REHEARSAL=short: the thesis' three staircases, ten people, twenty kills, with
  /// circles of 0.3 s. =whole: with the real circles of 5 s. Unset: a tenth of it.
  Scale scale() {
    const char* setting = std::getenv("HEDGEHOG_STUDY_REHEARSAL");
    const std::string which = setting != nullptr ? setting : "";
    if (which == "whole") return {"10", {"force-threshold", "force-jnd", "speed-jnd"}, 20, 8000};
    if (which == "short")
      return {"10",
              {quick_copy("force-threshold"), quick_copy("force-jnd"), quick_copy("speed-jnd")},
              20,
              2500};
    return {"3", {quick_path(), home_.path("quick-yes-no.json")}, 6, 250};
  }

  /// The answers of each run: kind, number and level of every trial that counts, and whether the
  /// answer was yes or right. Fails on voided trials that shifted others.
  std::map<std::string, std::vector<std::string>> answers(const std::string& folder) {
    std::map<std::string, std::vector<std::string>> all;
    for (const auto& file : fs::directory_iterator(home_.path(folder + "/journal"))) {
      const std::string name = file.path().filename().string();
      SCOPED_TRACE(name);
      Json trial;
      int attempt = 1;
      std::string entry;
      for (const Json& line : journal(name, folder)) {
        const std::string event = line["event"];
        if (event == "trial_started") {
          trial = line;
          EXPECT_EQ(trial["attempt"], attempt);
        } else if (event == "voided") {
          ++attempt;
          ++voids_;
        } else if (event == "answered") {
          attempt = 1;
          const std::string answer = line["answer"];
          const bool positive = answer == "yes" || answer == trial["interval_of_test"].dump();
          all[name].push_back(trial["kind"].get<std::string>() + " " + trial["trial"].dump() + " " +
                              trial["level"].dump() + (positive ? " +" : " -"));
        }
      }
    }
    return all;
  }

  std::vector<std::vector<Json>> journals(const std::string& folder) const {
    std::vector<std::vector<Json>> all;
    for (const auto& file : fs::directory_iterator(home_.path(folder + "/journal")))
      all.push_back(journal(file.path().filename().string(), folder));
    return all;
  }
  int count_all(const std::string& folder, const std::string& event) const {
    int sum = 0;
    for (const auto& lines : journals(folder)) sum += count(lines, event);
    return sum;
  }
  bool in_trial(const std::string& folder) const {
    for (const auto& lines : journals(folder))
      if (!lines.empty() && lines.back()["event"] == "trial_started") return true;
    return false;
  }

  int voids_ = 0;

 private:
  /// A preset with short circles.
  std::string quick_copy(const std::string& preset) const {
    std::ifstream in(source_folder() + "/config/study/" + preset + ".json");
    Json experiment = Json::parse(in, nullptr, true, true);
    experiment["name"] = "hasty-" + preset;
    experiment["duration_ms"] = 300;
    experiment["gap_ms"] = 100;
    home_.write(preset + ".json", experiment.dump());
    return home_.path(preset + ".json");
  }
};

TEST_F(Kills, AtAnyMomentChangeNoLevelAndNoAnswer) {
  const Scale scale = this->scale();
  std::string experiments;
  for (const std::string& experiment : scale.experiments)
    experiments += (experiments.empty() ? "" : ",") + experiment;
  start_daemon();
  store_address();
  plan("calm", scale.people, experiments);
  plan("shaken", scale.people, experiments);
  const Ended expected_run = wait_long(*begin({"rehearse"}, "calm"));
  ASSERT_EQ(expected_run.exit_code, 0) << expected_run.err;
  const auto expected = answers("calm");
  ASSERT_EQ(expected.size(), std::stoul(scale.people) * scale.experiments.size());

  std::mt19937 random(5);  // NOLINT(cert-msc51-cpp): the same moments each time
  auto runner = begin({"rehearse"}, "shaken");
  for (int kill = 0; kill < scale.kills; ++kill) {
    std::this_thread::sleep_for(std::chrono::milliseconds(
        std::uniform_int_distribution<int>(20, scale.longest_ms)(random)));
    if (kill % 2 == 0) {
      runner = nullptr;  // ends it by SIGKILL
      runner = begin({"rehearse"}, "shaken");
    } else {
      daemon_->stop(SIGKILL);
      start_daemon();
    }
  }
  // If no kill hit a trial by chance, the daemon is killed during one.
  for (int aimed = 0; aimed < 20 && count_all("shaken", "voided") == 0; ++aimed) {
    ASSERT_TRUE(eventually([&] {
      // A daemon that is killed before the runner has introduced itself ends the runner.
      if (has_ended(*runner)) runner = begin({"rehearse"}, "shaken");
      return in_trial("shaken");
    }));
    daemon_->stop(SIGKILL);
    start_daemon();
  }
  while (true) {
    const Ended ended = wait_long(*runner);
    ASSERT_NE(ended.exit_code, -1);
    if (ended.exit_code == 0) break;
    runner = begin({"rehearse"}, "shaken");
  }
  voids_ = 0;
  const auto found = answers("shaken");
  EXPECT_GT(voids_, 0) << "no kill hit a trial";
  ASSERT_EQ(found.size(), expected.size());
  for (const auto& [run, entry] : expected) {
    EXPECT_EQ(found.at(run), entry) << run;
    EXPECT_GT(entry.size(), 5U) << run;
  }
  EXPECT_EQ(thresholds("shaken"), thresholds("calm"));
  for (const auto& [run, threshold] : thresholds("calm")) EXPECT_TRUE(threshold.is_string()) << run;
}

}  // namespace
}  // namespace hedgehog::e2e
