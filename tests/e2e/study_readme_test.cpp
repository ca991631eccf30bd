// SPDX-License-Identifier: MIT
// hedgehog-study from its README to the report.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <sstream>

#include "tests/e2e/programs.h"
#include "tests/e2e/study_fixture.h"
#include "tests/folders.h"

namespace hedgehog::e2e {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

TEST_F(Study, AnalysesAndExportsTheMeasurements) {
  start_daemon();
  store_address();
  plan("th", "2", quick_path() + "," + home_.path("quick-yes-no.json"));
  ASSERT_EQ(study({"rehearse"}).exit_code, 0);
  const Ended analysed = study({"analyse"});
  ASSERT_EQ(analysed.exit_code, 0) << analysed.err;
  EXPECT_THAT(analysed.out, HasSubstr("n = 2"));
  EXPECT_THAT(analysed.err, HasSubstr("4 of 4 runs are of simulated people"));
  const std::string page = home_.read("th/analysis/report.html");
  EXPECT_THAT(page, HasSubstr("P02, quick"));  // a figure's title
  EXPECT_THAT(page, HasSubstr("about 10"));
  for (const char* figure : {"groups.svg", "groups.png", "P01.quick.1.svg", "P02.quick.1.png"})
    EXPECT_GT(fs::file_size(home_.path(std::string("th/analysis/figures/") + figure)), 2000U);
  ASSERT_EQ(study({"export"}).exit_code, 0);
  EXPECT_EQ(study({"export"}).exit_code, 73);
  ASSERT_EQ(study({"export", "--format", "bids"}).exit_code, 0);
  const std::string csv = home_.read("th/data.csv");
  EXPECT_THAT(csv, testing::StartsWith("participant,session,experiment,run,event,scored_trial"));
  const Json beside = Json::parse(home_.read("th/data.csv.json"));
  ASSERT_EQ(beside.size(), 4U);
  EXPECT_EQ(beside[0]["Participant"], "P01");
  EXPECT_EQ(beside[0]["SimulatedPerson"], true);
  const Json sidecar =
      Json::parse(home_.read("th/bids/sub-P01/beh/sub-P01_task-quick_run-1_beh.json"));
  EXPECT_EQ(sidecar["Protocol"]["name"], "quick");
  EXPECT_EQ(sidecar["Device"]["simulated"], true);
  EXPECT_THAT(home_.read("th/bids/sub-P02/beh/sub-P02_task-quickyesno_run-1_beh.tsv"),
              HasSubstr("\tcatch\t"));
}

TEST_F(Study, TheLinesOfItsReadmeRun) {
  start_daemon();
  store_address();
  std::ifstream text(source_folder() + "/clients/study/README.md");
  std::string folder = home_.path("");
  int ran = 0;
  const std::string program = "hedgehog-study ";
  for (std::string line; std::getline(text, line);) {
    const auto begin = line.find_first_not_of(' ');
    if (begin == std::string::npos || begin < 4) continue;
    line.erase(0, begin);
    if (line.rfind("cd ", 0) == 0) {
      folder = home_.path(line.substr(3));
      continue;
    }
    if (line.rfind(program, 0) != 0) continue;
    std::vector<std::string> words{"-C", folder};
    std::istringstream rest(line.substr(program.size()));
    for (std::string word; rest >> std::quoted(word);) {
      // Fewer simulated people than in the README: their numbers are tested elsewhere.
      words.push_back(word == "2000" ? "50" : word);
    }
    // The rehearsal's folder is inside the study's; a person is simulated, the whole study skipped.
    const auto has = [&](const char* word) {
      return std::find(words.begin(), words.end(), word) != words.end();
    };
    if (has("rehearse") || (has("analyse") && has("rehearsal"))) continue;
    if (has("run")) words.emplace_back("--simulated");
    Program command(home_, hedgehog_study(), words, variables());
    const Ended ended = command.wait();
    EXPECT_EQ(ended.exit_code, 0) << line << "\n" << ended.err;
    ++ran;
  }
  EXPECT_GE(ran, 9);
}

}  // namespace
}  // namespace hedgehog::e2e
