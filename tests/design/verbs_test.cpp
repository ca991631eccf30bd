// SPDX-License-Identifier: MIT
// Each verb, run as on the command line. Reference values: physics.md sections 1, 3, 4 and 6.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "clients/common/problem.h"
#include "clients/design/output/picture.h"
#include "clients/design/verbs/curves.h"
#include "tests/design/program.h"

namespace hedgehog::design {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;
using Json = nlohmann::json;

Json of_class(const Json& classes, int size) {
  for (const Json& one : classes)
    if (one.at("size") == size) return one;
  return nullptr;
}

TEST(Pair, IsTheReferencePair) {
  const auto force = [](const std::string& model) {
    const CommandResult result =
        run_design({"pair", "--magnet", "8x10", "--other", "4x10", "--sphere", "35", "--angle",
                    "12", "--offset", "0.5", "--model", model, "--accuracy", "1e-7", "--json"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return result.json().at("force_n").get<double>();
  };
  EXPECT_NEAR(force("exact"), 5.095441734e-01, 5e-7);
  EXPECT_NEAR(force("hybrid"), 5.095441734e-01, 5e-7);
  EXPECT_NEAR(force("dipole"), 1.24606862, 1e-7);
}

TEST(Pair, AreAllTheReferencePairs) {
  struct Reference {
    const char *magnet, *other, *sphere, *angle, *offset;
    double exact_n, dipole_n;
  };
  for (const Reference& one : {
           Reference{"8x10", "4x10", "35", "12", "0", 2.814818740e-01, 4.86718874e-01},
           {"8x10", "4x10", "35", "12", "0.5", 5.095441734e-01, 1.24606862e+00},
           {"8x10", "4x10", "35", "12", "2", 9.421484072e-01, 2.61646032e+00},
           {"8x10", "4x10", "35", "13.513", "0.5", 3.552409300e-01, 7.61415848e-01},
           {"8x10", "4x10", "35", "16.79", "0", 1.290455084e-01, 1.80465031e-01},
           {"8x10", "4x10", "35", "25", "5", 1.130912052e-01, 1.42550553e-01},
           {"8x10", "4x10", "35", "120", "1", 1.445087230e-03, 1.42175093e-03},
           {"8x10", "3x10", "35", "12.887", "0", 1.330857674e-01, 2.21600244e-01},
           {"8x10", "8x10", "35", "19.818", "0", 3.316491210e-01, 4.44402118e-01},
           {"8x10", "8x10", "35", "31.717", "0", 1.045739078e-01, 1.15839905e-01},
           {"8x10", "8x10", "35", "90", "0", 9.388069201e-03, 9.33165505e-03},
           {"6x8", "4x5", "30", "15", "0.5", 3.201178460e-01, 5.53460203e-01},
       }) {
    const auto force = [&](const char* model) {
      const CommandResult result = run_design(
          {"pair", "--magnet", one.magnet, "--other", one.other, "--sphere", one.sphere, "--angle",
           one.angle, "--offset", one.offset, "--model", model, "--accuracy", "1e-7", "--json"});
      EXPECT_EQ(result.exit_code, 0) << result.err;
      return result.json().at("force_n").get<double>();
    };
    EXPECT_NEAR(force("exact") / one.exact_n, 1.0, 1e-6) << one.angle << " " << one.offset;
    EXPECT_NEAR(force("dipole") / one.dipole_n, 1.0, 1e-6) << one.angle << " " << one.offset;
  }
}

TEST(Curves, OfEachModelOverOtherOffsets) {
  const auto at_rest_of_sixty = [](const char* model) {
    const Json curves = run_design({"curves", "--array", "tkD", "--model", model, "--offsets",
                                    "0..1/0.5", "--json"})
                            .json();
    EXPECT_EQ(curves.at("model"), model);
    const Json sixty = of_class(curves.at("classes"), 60);
    EXPECT_EQ(sixty.at("offsets_mm"), Json({0.0, 0.5, 1.0}));
    return sixty.at("force_n").at(1).get<double>();
  };
  const double exact_n = at_rest_of_sixty("exact");
  EXPECT_NEAR(exact_n, 0.0173417, 1e-3);
  EXPECT_NEAR(at_rest_of_sixty("hybrid"), exact_n, 0.2);
  EXPECT_GT(std::abs(at_rest_of_sixty("dipole") - exact_n), 1.0);
}

TEST(Curves, AreTitledAsTheThesisOnesForThatBallOnly) {
  const auto drawn = [](const Design& design) {
    const auto studies = figure_210(design).value();
    return gnuplot_script(curves_picture(studies, {-0.5, 2.0, 0.5}), "svg", "x.svg");
  };
  EXPECT_THAT(drawn({}), AllOf(HasSubstr("thesis Fig. 2.10"), HasSubstr("(thesis 0.6)"),
                               HasSubstr("Table 2.1")));
  for (const auto& change : std::vector<std::function<void(Design&)>>{
           [](Design& d) { d.sphere_mm = 36.0; }, [](Design& d) { d.remanence_t = 1.2; },
           [](Design& d) { d.coil_force_n = 0.3; }, [](Design& d) { d.magnet.height_mm = 9.0; },
           [](Design& d) { d.settings.model = model::ForceModel::kDipole; }}) {
    Design other;
    change(other);
    EXPECT_THAT(drawn(other), Not(HasSubstr("thesis")));
  }
}

// The labels of the thesis' axis are -2, 0, 2, 4 and 6 N, in all six panels.
TEST(Curves, OfTheFigureShareTheAxisOfTheThesisByDefault) {
  const auto count = [](const std::string& script, const std::string& words) {
    std::size_t found = 0;
    for (std::size_t at = script.find(words); at != std::string::npos;
         at = script.find(words, at + 1))
      ++found;
    return found;
  };
  const model::OffsetGrid grid{-2.5, 12.5, 0.5};
  const auto six = figure_210({}).value();
  const auto script = [&](const std::vector<Study>& studies, std::optional<Point> forces_n) {
    return gnuplot_script(curves_picture(studies, grid, forces_n), "svg", "x.svg");
  };
  EXPECT_EQ(count(script(six, {}), "set yrange [-3:6]\n"), 6U);
  EXPECT_EQ(count(script(six, {}), "set ytics 2\n"), 6U);
  EXPECT_EQ(count(script(six, Point{-1, 1}), "set yrange [-1:1]\n"), 6U);
  EXPECT_EQ(count(script(six, Point{}), "set yrange [*:*]\n"), 6U);
  EXPECT_EQ(count(script({six.front()}, {}), "set yrange [*:*]\n"), 1U);
  for (const char* forces : {"3", "6..-2", "1..1", "1..2/0.5", "all", "1..x"})
    EXPECT_EQ(run_design({"curves", "--array", "cD", "--forces", forces}).exit_code, kUsage)
        << forces;
  EXPECT_EQ(run_design({"curves", "--array", "cD", "--forces", "-2..6"}).exit_code, 0);
}

// An axis from -2 N, the lowest label of the thesis' axis, would cut off the curves of tkD.
TEST(Curves, OfTheFigureAreNotCutOffByItsAxis) {
  double lowest_n = 0.0;
  const model::OffsetGrid grid{-2.5, 12.5, 0.5};
  for (const Panel& panel : curves_picture(figure_210({}).value(), grid).panels) {
    for (const Series& series : panel.series) {
      for (const Point& point : series.points) {
        EXPECT_GE(point.y, panel.y_range.x) << panel.title << ", " << series.name;
        EXPECT_LE(point.y, panel.y_range.y) << panel.title << ", " << series.name;
        lowest_n = std::min(lowest_n, point.y);
      }
    }
  }
  EXPECT_LT(lowest_n, -2.9) << "else the axis could begin at -2 N";
}

TEST(Curves, AreThoseOfTheReference) {
  const CommandResult result =
      run_design({"curves", "--array", "tkD", "--magnet", "8x10", "--shield", "4x10", "--model",
                  "exact", "--accuracy", "1e-6", "--json"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const Json classes = result.json().at("classes");
  ASSERT_EQ(classes.size(), 3U);
  const Json sixty = of_class(classes, 60);
  ASSERT_EQ(sixty.at("offsets_mm").size(), 31U);
  ASSERT_EQ(sixty.at("force_n").size(), 31U);
  EXPECT_DOUBLE_EQ(sixty.at("offsets_mm").front(), -2.5);
  EXPECT_DOUBLE_EQ(sixty.at("offsets_mm").back(), 12.5);
  EXPECT_NEAR(sixty.at("force_n").at(5), 0.4504609, 1e-5);   // at 0
  EXPECT_NEAR(sixty.at("force_n").at(6), 0.0173417, 1e-5);   // at 0.5
  EXPECT_NEAR(sixty.at("force_n").at(21), 0.1168086, 1e-5);  // at 8
  EXPECT_NEAR(sixty.at("rest_mm"), 0.5220, 0.002);
  EXPECT_NEAR(sixty.at("extension_mm"), 0.589, 0.002);
}

TEST(Curves, AloneAreTheSixPanels) {
  const Json panels = run_design({"curves", "--json"}).json().at("panels");
  ASSERT_EQ(panels.size(), 6U);
  for (const Json& panel : panels) {
    for (const Json& one : panel.at("classes")) {
      EXPECT_EQ(one.at("stable"), panel.at("shield") == "4x10")
          << panel.at("array") << one.at("size");
    }
  }
  EXPECT_TRUE(of_class(panels[1].at("classes"), 30).at("extension_mm").is_null());
}

TEST(Curves, AcceptOtherOffsetsAndFormats) {
  const CommandResult csv =
      run_design({"curves", "--array", "cD", "--offsets", "0..1/0.25", "--csv"});
  EXPECT_THAT(csv.out, StartsWith("array,shield,class_size,offset_mm,force_n\ncD,4x10,12,0.0000,"));
  EXPECT_EQ(std::count(csv.out.begin(), csv.out.end(), '\n'), 1 + 2 * 5);
  EXPECT_EQ(run_design({"curves", "--offsets", "3"}).exit_code, kUsage);
  EXPECT_EQ(run_design({"curves", "--json", "--csv"}).exit_code, kUsage);
}

TEST(Table, IsPrintedBesideTheThesis) {
  const Json rows = run_design({"table", "--json"}).json().at("rows");
  ASSERT_EQ(rows.size(), 7U);
  const auto row = [&](const std::string& array, int size) {
    for (const Json& one : rows)
      if (one.at("array") == array && one.at("class_size") == size) return one;
    return Json();
  };
  EXPECT_NEAR(row("tkD", 12).at("crossings_mm"), 0.113, 0.002);
  EXPECT_NEAR(row("tkD", 60).at("crossings_mm"), 0.589, 0.002);
  EXPECT_NEAR(row("tkD", 20).at("crossings_mm"), 0.656, 0.002);
  EXPECT_NEAR(row("cD", 12).at("crossings_mm"), 0.878, 0.002);
  EXPECT_NEAR(row("wD", 60).at("crossings_mm"), 0.906, 0.002);
  // The shell shortens the travel of the first and of the fourth.
  EXPECT_NEAR(row("tkD", 12).at("extension_mm"), 0.060, 0.002);
  EXPECT_NEAR(row("tkD", 60).at("extension_mm"), 0.589, 0.002);
  EXPECT_NEAR(row("cD", 12).at("extension_mm"), 0.816, 0.002);
  // Deviating results are shown as computed, with the reason.
  EXPECT_TRUE(row("cD", 30).at("extension_mm").is_null());
  EXPECT_EQ(row("cD", 30).at("reproduced"), false);
  EXPECT_THAT(row("cD", 30).at("reason").get<std::string>(), HasSubstr("0.377 N at most"));
  EXPECT_EQ(row("wD", 60).at("reproduced"), false);
  EXPECT_EQ(row("wD", 12).at("reproduced"), true);
  EXPECT_THAT(run_design({"table"}).out, HasSubstr("not reproduced"));
  // For other magnets the thesis has no values to compare with.
  EXPECT_TRUE(run_design({"table", "--array", "cD", "--shield", "4.5x10", "--json"})
                  .json()["rows"][0]["thesis_mm"]
                  .is_null());
  for (const auto& words : {std::vector<std::string>{"table", "--remanence", "1.2", "--json"},
                            {"table", "--model", "dipole", "--json"}}) {
    const Json table = run_design(words).json();
    for (const Json& one : table.at("rows")) {
      EXPECT_TRUE(one.at("thesis_mm").is_null()) << words[1];
      EXPECT_EQ(one.at("reason"), "") << words[1];
    }
  }
}

TEST(Csv, HasOneNamePerColumn) {
  EXPECT_THAT(run_design({"pair", "--angle", "12", "--csv"}).out,
              StartsWith("model,force_n,error_n\nexact,0.2814"));
  EXPECT_THAT(run_design({"stability", "--array", "cD", "--csv"}).out,
              StartsWith("class_size,rest_mm,stiffness_n_mm,held_n,extension_mm,state,pins\n12,"));
  EXPECT_THAT(run_design({"choose", "--arrays", "tkD", "tkD", "--shields", "4x10", "--spheres",
                          "35", "--csv"})
                  .out,
              AllOf(StartsWith("array,pins,magnet,shield,sphere_mm,outer_diameter_mm,coil_force_n,"
                               "rest_mm,extension_mm,wall_mm,mass_kg\ntkD-86,86,8x10,4x10,35,")));
}

}  // namespace
}  // namespace hedgehog::design
