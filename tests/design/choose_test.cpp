// SPDX-License-Identifier: MIT
// The search: its results equal those of the full computation, on one thread and on two.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <ctime>
#include <limits>
#include <optional>
#include <stdexcept>

#include "clients/common/problem.h"
#include "clients/design/ball_numbers.h"
#include "clients/design/search/pull.h"
#include "clients/design/search/search.h"
#include "clients/design/search/workers.h"
#include "clients/design/study.h"
#include "tests/design/program.h"

namespace hedgehog::design {
namespace {

using testing::HasSubstr;

Found found(std::size_t pins, double extension_mm, double mass_g, double outer_mm) {
  Found one;
  one.pins = pins;
  one.extension_mm = extension_mm;
  one.mass_g = mass_g;
  one.outer_diameter_mm = outer_mm;
  return one;
}

std::vector<Found> pareto_front(std::vector<Found> found) {
  const auto accept_all = [](const std::vector<Found>& some) {
    return std::vector<std::optional<Found>>(some.begin(), some.end());
  };
  return checked_front(std::move(found), accept_all).front;
}

TEST(Front, HasTheDesignsThatNoneDominates) {
  const Found thesis = found(86, 0.59, 1180, 100);
  EXPECT_TRUE(dominates(thesis, found(66, 0.59, 1180, 100)));
  EXPECT_FALSE(dominates(thesis, thesis));
  EXPECT_FALSE(dominates(thesis, found(66, 0.90, 1180, 100)));
  const auto front = pareto_front({found(66, 0.5, 1200, 101), found(66, 0.9, 1100, 104), thesis,
                                   found(86, 0.5, 1180, 100), found(116, 0.5, 1300, 112)});
  ASSERT_EQ(front.size(), 3U);
  EXPECT_EQ(front[0].pins, 86U);  // the smallest ball first
  EXPECT_EQ(front[1].pins, 66U);
  EXPECT_EQ(front[2].pins, 116U);
}

TEST(Front, HasExactlyTheDesignsThatNoneDominates) {
  std::vector<Found> all;
  all.reserve(300);
  unsigned seed = 7;
  const auto next = [&seed] { return (seed = seed * 1103515245U + 12345U) >> 16 & 7U; };
  for (int i = 0; i < 300; ++i) all.push_back(found(next(), next(), next(), next()));
  const auto front = pareto_front(all);
  const auto is_dominated = [&](const Found& one) {
    return std::any_of(all.begin(), all.end(),
                       [&](const Found& other) { return dominates(other, one); });
  };
  for (const Found& one : front) EXPECT_FALSE(is_dominated(one));
  EXPECT_EQ(front.size(),
            static_cast<std::size_t>(std::count_if(
                all.begin(), all.end(), [&](const Found& one) { return !is_dominated(one); })));
}

TEST(Front, ARefusedDesignIsReplacedByThoseItDominates) {
  const Found best = found(86, 0.9, 1000, 98);
  const Found second = found(86, 0.8, 1100, 99);  // dominated by `best` only
  const Found third = found(86, 0.7, 1200, 100);  // dominated by both
  const Found other = found(116, 0.5, 1300, 112);
  std::size_t checked = 0;
  const auto front_without = [&](std::size_t refused_below_mm) {
    checked = 0;
    return checked_front({third, other, second, best}, [&](const std::vector<Found>& some) {
      checked += some.size();
      std::vector<std::optional<Found>> results;
      results.reserve(some.size());
      for (const Found& one : some) {
        const bool accepted = one.outer_diameter_mm >= static_cast<double>(refused_below_mm);
        results.push_back(accepted ? std::optional(one) : std::nullopt);
      }
      return results;
    });
  };
  const auto all = front_without(0);
  ASSERT_EQ(all.front.size(), 2U);
  EXPECT_EQ(all.front[0].outer_diameter_mm, 98);
  EXPECT_EQ(checked, 2U) << "who is beaten by one that stays is not asked about";
  const auto without_first = front_without(99);
  ASSERT_EQ(without_first.front.size(), 2U);
  EXPECT_EQ(without_first.front[0].outer_diameter_mm, 99);
  EXPECT_EQ(without_first.front[1].pins, 116U);
  EXPECT_EQ(without_first.refused, 1U);
  EXPECT_EQ(front_without(100).front[0].outer_diameter_mm, 100);
  const auto none = front_without(200);
  EXPECT_TRUE(none.front.empty());
  EXPECT_EQ(none.refused, 4U);
}

// The front contains the designs that the check returns, sorted, and none dominates another.
TEST(Front, IsOfTheDesignsReturnedByTheCheck) {
  const auto front =
      checked_front({found(86, 0.9, 1000, 100), found(86, 0.8, 900, 102), found(86, 0.7, 800, 104)},
                    [](const std::vector<Found>& some) {
                      std::vector<std::optional<Found>> built(some.begin(), some.end());
                      for (auto& one : built)
                        if (one->outer_diameter_mm == 102) one->mass_g = 1100;
                      return built;
                    })
          .front;
  ASSERT_EQ(front.size(), 2U);
  EXPECT_EQ(front[0].outer_diameter_mm, 100);
  EXPECT_EQ(front[1].outer_diameter_mm, 104);
}

TEST(Workers, RethrowTheErrorOfAnItem) {
  std::atomic<int> done = 0;
  const auto work = [&](std::size_t i) {
    ++done;
    if (i == 3) throw std::runtime_error("three");
  };
  EXPECT_THROW(parallel_for(20, 2, work, [](std::size_t) {}), std::runtime_error);
  EXPECT_EQ(done, 20);
}

TEST(Workers, ProcessEachItemOnce) {
  std::vector<std::atomic<int>> done(500);
  std::size_t last_progress = 0;
  parallel_for(
      done.size(), 3, [&](std::size_t i) { ++done[i]; },
      [&](std::size_t so_far) { last_progress = so_far; });
  for (const auto& one : done) EXPECT_EQ(one, 1);
  EXPECT_EQ(last_progress, done.size());
  parallel_for(
      0, 2, [](std::size_t) { FAIL(); }, [](std::size_t) {});
}

TEST(Pull, IsTheFullForceBetweenItsNodes) {
  // Up to the largest diameter of a search, which leaves 0.3 mm of plastic.
  std::vector<double> diameters;
  for (int i = 0; i <= 22; ++i) diameters.push_back(3.0 + 0.05 * i);
  Design design;
  design.array = "tkD";
  design.settings.accuracy = 1e-7;
  const auto classes = model::symmetry_classes(find_arrangement("tkD").value());
  for (const model::PinClass& one : classes) {
    auto sizes = design.sizes();
    const Pull pull(one, sizes, diameters);
    for (const double diameter_mm : {3.0, 3.65, 4.0, 4.1}) {
      sizes.shield.diameter_mm = diameter_mm;
      const auto exact =
          model::force_curve(model::PinForce(one, sizes, design.settings), kSearchGrid).force_n;
      const auto quick = pull.force_n(diameter_mm, 1.0);
      for (std::size_t i = 0; i < exact.size(); ++i)
        EXPECT_NEAR(quick[i], exact[i], 1e-3) << diameter_mm << " " << i;
    }
  }
}

TEST(Search, FindsTheBallOfTheThesis) {
  SearchSpace space{{"tkD"}, {{8, 10}}, {{4, 10}}, {35.0}, {}};
  const auto outcome = Search::in(space, Demands{}).value().run(1, [](std::size_t) {});
  EXPECT_EQ(outcome.looked_at, 1U);
  ASSERT_EQ(outcome.front.size(), 1U);
  const Found& ball = outcome.front.front();
  EXPECT_EQ(ball.design.array, "tkD-86");
  EXPECT_EQ(ball.pins, 86U);
  EXPECT_EQ(ball.shields, 170U);
  // Equal to the full computation of the 86 pins (of all 92: 0.522 and 0.589 mm).
  const Study study = Study::of(ball.design).value();
  EXPECT_NEAR(ball.rest_mm, *study.typical().rest_mm(), 1e-6);
  EXPECT_NEAR(ball.extension_mm, *study.typical().extension_mm(), 1e-6);
  EXPECT_NEAR(ball.rest_mm, 0.486, 0.002);
  EXPECT_NEAR(ball.extension_mm, 0.577, 0.002);
  EXPECT_NEAR(ball.design.coil_force_n, 0.4, 1e-6);
  EXPECT_NEAR(ball.mass_g, mass_of(find_arrangement("tkD-86").value(), ball.design).total_g(),
              1e-6);
  EXPECT_NEAR(ball.outer_diameter_mm, 100, 1e-9);
}

// Ten thousand designs in a minute are 6 ms each. Compared within one run with the full computation
// of one design, about 10 ms; in a search a design takes a tenth of that. Processor time, measured
// alternately, the minimum of up to five each: other load on the machine can only increase it.
TEST(Search, EvaluatesADesignFasterThanTheFullComputation) {
  SearchSpace space{{"tkD"}, {{8, 10}}, {}, {35.0, 35.5, 36.0, 36.5}, {}};
  for (int i = 0; i <= 40; ++i) space.shields.push_back({3.0 + 0.05 * i, 10.0});
  Design design;
  design.array = "tkD";
  double in_search = std::numeric_limits<double>::infinity();
  double full = std::numeric_limits<double>::infinity();
  for (int turn = 0; turn < 5 && !(in_search < full / 3.0); ++turn) {
    const auto search = Search::in(space, Demands{}).value();
    const std::clock_t start = std::clock();
    const auto outcome = search.run(1, [](std::size_t) {});
    const std::clock_t middle = std::clock();
    ASSERT_TRUE(Study::of(design).has_value());
    full = std::min(full, static_cast<double>(std::clock() - middle));
    in_search = std::min(in_search, static_cast<double>(middle - start) / 164.0);
    EXPECT_EQ(outcome.looked_at, 164U);
  }
  EXPECT_LT(in_search, full / 3.0);
}

TEST(Search, RequirementsExcludeDesigns) {
  const auto front_size = [](const SearchSpace& space, const Demands& demands) {
    return Search::in(space, demands).value().run(1, [](std::size_t) {}).front.size();
  };
  const SearchSpace thesis{{"tkD"}, {{8, 10}}, {{4, 10}}, {35.0}, {}};
  EXPECT_EQ(front_size(thesis, {.margin = 0.2}), 0U);
  EXPECT_EQ(front_size(thesis, {.min_extension_mm = 0.7}), 0U);
  EXPECT_EQ(front_size(thesis, {.wall_mm = 0.5}), 0U);  // the wall has 0.38 mm
  EXPECT_EQ(front_size(thesis, {.travel_mm = 1.0}), 0U);
  // 3 mm shields hold no pin; cD's class of 30 is not held against 0.4 N.
  EXPECT_EQ(front_size({{"cD", "wD", "tkD"}, {{8, 10}}, {{3, 10}}, {35.0}, {}}, {.margin = 0.0}),
            0U);
  EXPECT_EQ(front_size({{"cD"}, {{8, 10}}, {{4, 10}}, {35.0}, {}}, {.margin = 0.0}), 0U);
  // GP(2,2) does not fit at 35 mm.
  const auto dense = Search::in({{"GP(2,2)"}, {{8, 10}}, {{4, 10}}, {35.0}, {}}, {})
                         .value()
                         .run(1, [](std::size_t) {});
  EXPECT_EQ(dense.fit, 0U);
}

TEST(Choose, FindsTheSameOnOneThreadAndOnTwo) {
  const auto found_by = [](const std::string& threads) {
    return run_design({"choose", "--arrays", "cD", "wD", "--shields", "3.8..4.6/0.2x10",
                       "--spheres", "35..36/0.5", "--threads", threads, "--json"});
  };
  const CommandResult one = found_by("1");
  ASSERT_EQ(one.exit_code, 0) << one.err;
  EXPECT_EQ(one.out, found_by("2").out);
  EXPECT_EQ(one.json().at("looked_at"), 2 * 5 * 3);
  EXPECT_GE(one.json().at("front").size(), 1U);
  EXPECT_EQ(one.json().at("best"), one.json().at("front").front());
}

TEST(Choose, SavesADesignForOtherVerbs) {
  const TemporaryFolder folder;
  const std::string file = folder.path("best.json");
  const CommandResult result = run_design(
      {"choose", "--arrays", "tkD", "--shields", "3.9..4.1x10", "--spheres", "35", "--save", file});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out,
              HasSubstr("tkD-86, 86 pins 8x10, shields 4x10, sphere 35 mm, 0.58 mm, 1.5 kg"));
  // The wall is reported, because no printer makes one as thin.
  EXPECT_THAT(result.out, HasSubstr("its casing has walls of 0.03 mm"));
  EXPECT_EQ(run_design({"stability", file, "--json"}).json().at("stable"), true);
  const CommandResult no_result = run_design(
      {"choose", "--arrays", "tkD", "--shields", "3x10", "--spheres", "35", "--save", file + "2"});
  EXPECT_EQ(no_result.exit_code, kBadData);
  EXPECT_FALSE(std::filesystem::exists(file + "2"));
}

TEST(Choose, RefusesImpossibleSearches) {
  const auto error_message = [](std::vector<std::string> words) {
    words.insert(words.begin(), "choose");
    const CommandResult result = run_design(words);
    EXPECT_EQ(result.exit_code, kUsage);
    return result.err;
  };
  EXPECT_THAT(error_message({"--spheres", "30"}), HasSubstr("inside the electromagnet"));
  EXPECT_THAT(error_message({"--arrays", "tkd"}), HasSubstr("did you mean 'tkD'?"));
  EXPECT_THAT(error_message({"--arrays", "tkD-86"}), HasSubstr("whole arrays"));
  EXPECT_THAT(error_message({"--pins", "8"}), HasSubstr("--pins"));
  EXPECT_THAT(error_message({"--shields", "5..3x10"}), HasSubstr("ends below where it begins"));
  EXPECT_THAT(error_message({"--wall", "nan"}), HasSubstr("--wall: must be from 0 to 20"));
  EXPECT_THAT(error_message({"--margin", "nan"}), HasSubstr("--margin: must be from 0 to 50"));
  EXPECT_THAT(error_message({"--least-extension", "1.6"}), HasSubstr("must be from 0 to 1.5"));
  EXPECT_THAT(error_message({"--pins", "5..9/0.01x8..12/0.1"}),
              HasSubstr("more than five million"));
}

}  // namespace
}  // namespace hedgehog::design
