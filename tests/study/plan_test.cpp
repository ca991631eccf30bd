// SPDX-License-Identifier: MIT
// The plan of a study: participants, their names and the order of their experiments.
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <iterator>
#include <map>
#include <set>

#include "clients/study/study_folder.h"
#include "tests/temporary_folder.h"

namespace hedgehog::study {
namespace {

namespace fs = std::filesystem;

TEST(StudyFolder, IsFoundFromSubfoldersAndNeverCreatedTwice) {
  const TemporaryFolder temporary;
  const fs::path folder = temporary.path();
  const StudyPlan plan = make_plan(10, {"force-threshold", "force-jnd", "speed-jnd"}, 2026);
  ASSERT_TRUE(StudyFolder::create(folder / "thresholds", plan).has_value());
  EXPECT_EQ(StudyFolder::create(folder / "thresholds", plan).error().exit_code, EX_CANTCREAT);
  const auto found = StudyFolder::find(folder / "thresholds" / "journal").value();
  ASSERT_EQ(found.plan().participants.size(), 10U);
  EXPECT_EQ(found.plan().participant("P07")->seed, plan.participants[6].seed);
  EXPECT_EQ(found.plan().participant("P07")->order, plan.participants[6].order);
  EXPECT_EQ(found.plan().participant("P11"), nullptr);
  EXPECT_EQ(StudyFolder::find(folder).error().exit_code, EX_NOINPUT);
  // If `plan` was killed before it wrote study.json, the next one succeeds and leaves no other
  // files.
  fs::remove(folder / "thresholds" / "study.json");
  ASSERT_TRUE(StudyFolder::create(folder / "thresholds", plan).has_value());
  EXPECT_EQ(std::distance(fs::directory_iterator(folder / "thresholds"), {}), 2);
  EXPECT_EQ(found.is_unmistakable(std::string("P-07")).error().exit_code, EX_USAGE);
  EXPECT_EQ(found.is_unmistakable(std::string("-")).error().exit_code, EX_USAGE);
  EXPECT_TRUE(found.is_unmistakable(std::string("P07")));
  EXPECT_TRUE(found.is_unmistakable(std::string("P-11")));
}

TEST(Plan, ANulEndsNoFile) {
  const std::string good = plan_text(make_plan(1, {"a"}, 5));
  EXPECT_TRUE(parse_plan(good).has_value());
  EXPECT_EQ(parse_plan(good + '\0' + "garbage").error().message,
            "has a NUL byte, which JSON never has");
}

TEST(Plan, TheSameSeedMakesTheSamePlan) {
  const StudyPlan a = make_plan(3, {"a", "b"}, 5);
  const StudyPlan b = make_plan(3, {"a", "b"}, 5);
  EXPECT_EQ(a.participants[2].seed, b.participants[2].seed);
  EXPECT_NE(a.participants[1].seed, a.participants[2].seed);
  EXPECT_NE(run_seeds(a.participants[0], "a", 1), run_seeds(a.participants[0], "a", 2));
  EXPECT_NE(run_seeds(a.participants[0], "a", 1), run_seeds(a.participants[0], "b", 1));
}

TEST(Plan, EachExperimentIsInEachPlaceAndAfterEachOtherEquallyOften) {
  for (int count = 1; count <= 6; ++count) {
    std::map<std::pair<int, int>, int> places;
    std::map<std::pair<int, int>, int> followers;
    const auto rows = latin_square(count);
    EXPECT_EQ(static_cast<int>(rows.size()), count % 2 == 0 || count == 1 ? count : 2 * count);
    // The first `count` rows alone are a Latin square too.
    std::set<std::pair<int, int>> first_places;
    for (const auto& row : rows) {
      for (int place = 0; place < count; ++place) {
        ++places[{place, row[static_cast<std::size_t>(place)]}];
        if (&row - rows.data() < count)
          first_places.emplace(place, row[static_cast<std::size_t>(place)]);
        if (place > 0) {
          ++followers[{row[static_cast<std::size_t>(place - 1)],
                       row[static_cast<std::size_t>(place)]}];
        }
      }
    }
    EXPECT_EQ(static_cast<int>(first_places.size()), count * count);
    EXPECT_EQ(static_cast<int>(places.size()), count * count);
    for (const auto& [which, times] : places)
      EXPECT_EQ(times, static_cast<int>(rows.size()) / count);
    EXPECT_EQ(static_cast<int>(followers.size()), count * (count - 1));
    for (const auto& [which, times] : followers) EXPECT_EQ(times, followers.begin()->second);
  }
}

}  // namespace
}  // namespace hedgehog::study
