// SPDX-License-Identifier: MIT
// Output files of the designer: printable casings, device files that the daemon accepts, pictures,
// a report.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "clients/common/html.h"
#include "clients/common/problem.h"
#include "clients/common/text.h"
#include "clients/design/casing/casing.h"
#include "clients/design/casing/stl.h"
#include "clients/design/input/design.h"
#include "clients/design/output/picture.h"
#include "clients/design/output/table.h"
#include "tests/config/fake_files.h"
#include "tests/design/program.h"

namespace hedgehog::design {
namespace {

using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

TEST(Export, HalvesAreClosed) {
  const TemporaryFolder folder;
  const std::string csv = folder.write("small.csv", kSmallBall);
  const CommandResult result =
      run_design({"export", "--positions", csv, "--facets", "8", "--stl", folder.path("casing"),
                  "--scad", folder.path("casing.scad")});
  ASSERT_EQ(result.exit_code, 0) << result.err << "(openscad must be installed: make deps)";
  double printed_mm3 = 0.0;
  for (const char* half : {"casing/upper.stl", "casing/lower.stl"}) {
    const auto surface = check_stl(folder.read(half)).value();
    EXPECT_EQ(surface.open_edges, 0U) << half;
    EXPECT_GT(surface.triangles, 500U) << half;
    // Half a shell with radii of 35 and 50 mm, minus the cavities.
    const double shell = 2.0 / 3.0 * std::numbers::pi * (125000.0 - 42875.0);
    EXPECT_LT(surface.volume_mm3, shell);
    EXPECT_GT(surface.volume_mm3, 0.7 * shell);
    printed_mm3 += surface.volume_mm3;
  }
  // The volume from which the mass is computed: without tabs and the notch for the cables.
  Design design;
  design.positions = csv;
  const auto array = arrangement_of(design).value();
  Casing casing = casing_of(design, array);
  casing.facets = 8;
  casing.fan_mm = widest_fan_mm(casing);
  EXPECT_NEAR(printed_mm3 / volume_mm3(casing), 1.0, 0.02);
  EXPECT_THAT(folder.read("casing.scad"), HasSubstr("pin_diameter = 8;"));
}

TEST(Export, OverlappingCavitiesAreRefused) {
  const TemporaryFolder folder;
  const std::string scad = folder.path("c.scad");
  const CommandResult ball = run_design({"export", "--scad", scad, "--clearance", "0.15"});
  EXPECT_EQ(ball.exit_code, 0) << ball.err;
  EXPECT_THAT(ball.err, HasSubstr("thinnest wall 0.0"));
  EXPECT_THAT(ball.err, HasSubstr("between pin"));
  EXPECT_THAT(ball.err, HasSubstr("a common nozzle prints lines of 0.4 mm"));
  // The default clearance leaves a wall.
  const CommandResult printable = run_design({"export", "--scad", scad});
  EXPECT_THAT(printable.err, HasSubstr("thinnest wall 0.2"));
  EXPECT_THAT(printable.err, HasSubstr("clearance 0.05 mm"));
  const CommandResult wide = run_design({"export", "--scad", scad, "--array", "cD"});
  EXPECT_THAT(wide.err, HasSubstr("clearance 0.15 mm"));
  EXPECT_THAT(wide.err, Not(HasSubstr("nozzle")));
  std::filesystem::remove(scad);
  for (const std::vector<std::string>& more :
       {std::vector<std::string>{"--facets", "8", "--clearance", "0.15"},
        {"--clearance", "0.3"},
        {"--shield", "4.7x10"}}) {
    std::vector<std::string> words{"export", "--scad", scad};
    words.insert(words.end(), more.begin(), more.end());
    const CommandResult refused = run_design(words);
    EXPECT_EQ(refused.exit_code, kBadData) << more.front();
    EXPECT_THAT(refused.err, HasSubstr("run into each other")) << more.front();
    EXPECT_FALSE(std::filesystem::exists(scad)) << more.front();
  }
  Casing casing;
  EXPECT_DOUBLE_EQ(cavity_reach_mm(casing, {8, 10}), 4.15);
  casing.facets = 8;
  EXPECT_NEAR(cavity_reach_mm(casing, {8, 10}), 4.3296, 1e-4) << "4 mm between the sides";
}

TEST(Export, AnOpenModelIsNotReportedAsClosed) {
  const TemporaryFolder folder;
  const std::string scad =
      folder.write("x.scad", "polyhedron([[0,0,0],[1,0,0],[0,1,0]], [[0,1,2]]);");
  EXPECT_FALSE(render_stl(scad, "upper", folder.path("x.stl")).has_value());
  EXPECT_FALSE(
      render_stl(folder.write("y.scad", "cube("), "upper", folder.path("y.stl")).has_value());
}

TEST(Export, TheDaemonAcceptsTheDeviceFile) {
  const TemporaryFolder folder;
  ASSERT_EQ(run_design({"export", "--device", folder.path("ball-9.json")}).exit_code, 0);
  const auto files = config::FakeFiles::with_device(folder.read("ball-9.json"));
  ASSERT_EQ(files.errors(), "");
  EXPECT_EQ(files.load()->device.name, "ball-9");
  EXPECT_EQ(files.load()->device.geometry.arrangement, "tkD-86");
  EXPECT_NEAR(files.load()->device.force_slope_n_a, 0.0126, 1e-6);
}

// The daemon places the magnets where the design, and so the printed casing, has them.
TEST(Export, TheDaemonAcceptsTheDeviceFileOfAnyDesign) {
  for (const std::vector<std::string>& flags :
       {std::vector<std::string>{"--array", "wD-66"},
        {"--array", "GP(2,2)-116", "--magnet", "5x10", "--shield", "3x10"},
        {"--array", "cD", "--remove-pins", "3,17", "--remove-shields", "0-4"},
        {"--shield", "3.8x10", "--remanence", "1.2"},
        {"--array", "tkD-86-20"}}) {
    const TemporaryFolder folder;
    std::vector<std::string> words{"export", "--device", folder.path("b.json")};
    words.insert(words.end(), flags.begin(), flags.end());
    const CommandResult exported = run_design(words);
    ASSERT_EQ(exported.exit_code, 0) << exported.err;
    const auto files = config::FakeFiles::with_device(folder.read("b.json"));
    ASSERT_EQ(files.errors(), "") << folder.read("b.json");
    const auto driven = model::arrangement_of(files.load()->device.geometry);
    ASSERT_TRUE(driven.has_value()) << driven.error().message;
    words = {"array", "--json"};
    words.insert(words.end(), flags.begin(), flags.end());
    const auto drawn = run_design(words).json();
    ASSERT_EQ(driven->pins.size(), drawn.at("positions").at("pins").size()) << flags.back();
    EXPECT_EQ(driven->shields.size(), drawn.at("positions").at("shields").size()) << flags.back();
    for (const auto& site : drawn.at("positions").at("pins")) {
      const auto at = [&](int axis) { return site.at("direction").at(axis).get<double>(); };
      const model::Vec3 direction = model::unit_or({at(0), at(1), at(2)}, {0, 0, 1});
      EXPECT_TRUE(std::any_of(
          driven->pins.begin(), driven->pins.end(),
          [&](const auto& pin) { return model::norm(pin.direction - direction) < 1e-4; }))
          << flags.back() << " " << site;
    }
  }
}

TEST(Export, NoDeviceFileThatTheDaemonWouldRefuse) {
  const TemporaryFolder folder;
  const CommandResult result = run_design({"export", "--magnet", "4x6", "--shield", "2x6",
                                           "--sphere", "60", "--device", folder.path("b.json")});
  EXPECT_EQ(result.exit_code, kBadData) << result.out;
  EXPECT_THAT(result.err, HasSubstr("0.001 to 0.1 N/A"));
  EXPECT_FALSE(std::filesystem::exists(folder.path("b.json")));
}

TEST(Export, NoDeviceFileForAListOfPositions) {
  const TemporaryFolder folder;
  ASSERT_EQ(run_design({"export", "--csv", folder.path("p.csv")}).exit_code, 0);
  const CommandResult result = run_design(
      {"export", "--positions", folder.path("p.csv"), "--device", folder.path("b.json")});
  EXPECT_EQ(result.exit_code, kBadData);
  EXPECT_THAT(result.err, HasSubstr("knows the arrays by name only"));
  EXPECT_FALSE(std::filesystem::exists(folder.path("b.json")));
  EXPECT_EQ(run_design({"export", "--device", folder.path("a ball.json")}).exit_code, kUsage);
}

TEST(Export, ADashIsStdout) {
  const TemporaryFolder folder;
  const auto before = std::filesystem::current_path();
  std::filesystem::current_path(folder.path());
  const CommandResult casing = run_design({"export", "--array", "cD", "--scad", "-"});
  const CommandResult device = run_design({"export", "--device", "-"});
  const bool folder_is_empty = std::filesystem::is_empty(folder.path());
  std::filesystem::current_path(before);
  EXPECT_EQ(casing.exit_code, 0) << casing.err;
  EXPECT_THAT(casing.out, HasSubstr("pin_diameter = 8;"));
  EXPECT_EQ(device.exit_code, kUsage);
  EXPECT_THAT(device.err, HasSubstr("the file's name is the ball's"));
  EXPECT_TRUE(folder_is_empty);
}

TEST(Export, PositionsInAFileOrOnTheCommandLine) {
  const TemporaryFolder folder;
  ASSERT_EQ(run_design({"export", "--csv", folder.path("p.csv"), "--json", folder.path("p.json")})
                .exit_code,
            0);
  EXPECT_EQ(folder.read("p.csv"), run_design({"export", "--csv"}).out);
  EXPECT_EQ(folder.read("p.json"), run_design({"export", "--json"}).out);
  EXPECT_EQ(
      run_design({"stability", "--positions", folder.path("p.csv"), "--json"}).json().at("stable"),
      true);
  const std::string design = folder.write("best.json", "{\"array\": \"cD\"}");
  EXPECT_EQ(run_design({"export", "--json", design}).exit_code, kUsage);
  EXPECT_EQ(folder.read("best.json"), "{\"array\": \"cD\"}");
  EXPECT_EQ(run_design({"export", "--fan", "60", "--scad", folder.path("c.scad")}).exit_code,
            kBadData);
  EXPECT_EQ(run_design({"export", "--facets", "7", "--scad", folder.path("c.scad")}).exit_code,
            kUsage);
}

TEST(Pictures, HaveLabelledAxesWithUnits) {
  const TemporaryFolder folder;
  const CommandResult curves =
      run_design({"curves", "--svg", folder.path("c.svg"), "--png", folder.path("c.png")});
  ASSERT_EQ(curves.exit_code, 0) << curves.err << "(gnuplot must be installed: make deps)";
  const std::string svg = folder.read("c.svg");
  for (const char* words : {"offset of the pin (mm)", "force on the pin, outwards (N)",
                            "tkD, 4 mm shields", "(thesis 3.5)", "thesis' rest 0.45 mm"})
    EXPECT_TRUE(svg.find(words) != std::string::npos) << words;
  EXPECT_THAT(folder.read("c.png"), StartsWith("\x89PNG"));
  ASSERT_EQ(run_design({"electromagnet", "--svg", folder.path("e.svg")}).exit_code, 0);
  EXPECT_THAT(folder.read("e.svg"), HasSubstr("current (A)"));
}

TEST(Pictures, WordsAreNotCommands) {
  Picture picture;
  picture.panels.push_back(
      {"it's `date`\nset output 'x'", "x", "y", {{"s", {{0, 1}, {1, 2}}, {}, 0}}, {}, {}, {}});
  const std::string script = gnuplot_script(picture, "svg", "out.svg");
  EXPECT_THAT(script, HasSubstr("set title 'it''s `date` set output ''x''' noenhanced"));
  EXPECT_THAT(script, Not(HasSubstr("\nset output 'x'")));
}

TEST(Report, IsOneFile) {
  const TemporaryFolder folder;
  const CommandResult result = run_design(
      {"report", "--array", "cD", "--shield", "4.4x10", "--output", folder.path("r.html")});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const std::string page = folder.read("r.html");
  EXPECT_THAT(page, StartsWith("<!DOCTYPE html>"));
  EXPECT_THAT(page, HasSubstr("Every pin rests: all 42 are stable."));
  EXPECT_THAT(page, HasSubstr("0.377 N at most"));
  EXPECT_THAT(page, HasSubstr("<svg"));
  EXPECT_THAT(page, Not(HasSubstr("src=")));
  EXPECT_THAT(page, Not(HasSubstr("href=\"http")));
  // Unstable pins are reported too, without a coil, because nothing holds them against it.
  ASSERT_EQ(
      run_design({"report", "--array", "cD", "--shield", "3x10", "--output", folder.path("u.html")})
          .exit_code,
      0);
  EXPECT_THAT(folder.read("u.html"), HasSubstr("42 pins are unstable: 0-41"));
}

TEST(Tables, AlignAndQuote) {
  Table table({{"name", "name", true}, {"N", "force_n"}});
  table.add({"ä, b", "1.5"});
  table.add({"c\"d", "10"});
  EXPECT_EQ(table.text(), "  name    N\n  ä, b  1.5\n  c\"d    10\n");
  EXPECT_EQ(table.csv(), "name,force_n\n\"ä, b\",1.5\n\"c\"\"d\",10\n");
  EXPECT_EQ(fixed(-0.0001, 2), "0.00");
  EXPECT_EQ(fixed(std::nan(""), 2), "none");
  EXPECT_EQ(client::wrapped("one two three", 9, 2), "  one two\n  three\n");
  EXPECT_EQ(client::escape_html("<a & \"b\">"), "&lt;a &amp; &quot;b&quot;&gt;");
}

}  // namespace
}  // namespace hedgehog::design
