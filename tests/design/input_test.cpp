// SPDX-License-Identifier: MIT
// Parsing of the input, and the error messages for invalid input.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

#include "clients/common/problem.h"
#include "clients/design/input/design_file.h"
#include "clients/design/input/positions_file.h"
#include "clients/design/input/sizes.h"
#include "model/magnets/ball_geometry.h"
#include "tests/design/program.h"

namespace hedgehog::design {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

TEST(Sizes, AreDiameterTimesHeight) {
  EXPECT_EQ(parse_size("8x10", "--magnet").value(), (Size{8, 10}));
  EXPECT_EQ(parse_size("4.5x9.25", "--magnet").value(), (Size{4.5, 9.25}));
  EXPECT_EQ(to_text(Size{4.5, 10}), "4.5x10");
  for (const char* wrong : {"", "8", "8x", "x10", "8x10x2", "8 x 10", "axb", "nanx10", "8x10mm"}) {
    EXPECT_THAT(parse_size(wrong, "--magnet").error().message, HasSubstr("DIAMETERxHEIGHT"))
        << wrong;
  }
  EXPECT_THAT(parse_size("-8x10", "--magnet").error().message, HasSubstr("-8 mm is outside"));
}

TEST(Sizes, RangesHaveSteps) {
  EXPECT_THAT(parse_range("3..5/0.5", 1, 0, 9, "").value(), ElementsAre(3, 3.5, 4, 4.5, 5));
  EXPECT_THAT(parse_range("3..5", 1, 0, 9, "").value(), ElementsAre(3, 4, 5));
  EXPECT_THAT(parse_range("-2.5", 1, -9, 9, "").value(), ElementsAre(-2.5));
  EXPECT_EQ(parse_range("3..5/0.05", 1, 0, 9, "").value().size(), 41U);
  EXPECT_EQ(parse_sizes("3..4/0.5x8..10", 0.1, "").value().size(), 9U);
  for (const char* wrong :
       {"", "..", "3..", "5..3", "3..5/0", "3..5/-1", "3..5/1e-9", "3..99", "a..b"})
    EXPECT_FALSE(parse_range(wrong, 1, 0, 9, "--x").has_value()) << wrong;
}

TEST(Arrays, AreFoundByName) {
  const auto counts = [](const std::string& name) {
    const auto array = find_arrangement(name).value();
    return std::pair(array.pins.size(), array.shields.size());
  };
  EXPECT_EQ(counts("cD"), std::pair(42UL, 80UL));
  EXPECT_EQ(counts("wD"), std::pair(72UL, 140UL));
  EXPECT_EQ(counts("tkD"), std::pair(92UL, 180UL));
  EXPECT_EQ(counts("tkD-86"), std::pair(86UL, 170UL));
  EXPECT_EQ(counts("tkD-86-20"), std::pair(86UL, 160UL));
  EXPECT_EQ(counts("cD-36"), std::pair(36UL, 70UL));
  EXPECT_EQ(counts("GP(2,2)-116"), std::pair(116UL, 230UL));
}

TEST(Arrays, OpeningsAreThoseOfTheModel) {
  // The one opening that the model defines itself, made here from the whole array.
  for (const auto& [name, shields] :
       {std::pair("GP(3,0)-86", 170UL), std::pair("GP(3,0)-86-5", 175UL),
        std::pair("GP(3,0)-86-20", 160UL)}) {
    const auto opened = find_arrangement(name).value();
    ASSERT_EQ(opened.shields.size(), shields) << name;
    ASSERT_EQ(opened.pins.size(), 86U);
    for (const auto& pin : model::thesis_ball().array.pins) {
      EXPECT_TRUE(std::any_of(
          opened.pins.begin(), opened.pins.end(),
          [&](const auto& site) { return model::norm(site.direction - pin.position) < 1e-6; }))
          << name << " has no pin " << pin.id;
    }
  }
}

TEST(Arrays, UnknownNamesGetASuggestion) {
  const auto sentence = [](const std::string& name) {
    return find_arrangement(name).error().message;
  };
  EXPECT_THAT(sentence("tkd"), HasSubstr("did you mean 'tkD'?"));
  EXPECT_THAT(sentence("tkD-85"), HasSubstr("did you mean 'tkD-86'?"));
  EXPECT_THAT(sentence("cd-36"), HasSubstr("did you mean 'cD-36'?"));
  EXPECT_THAT(sentence("soccer"), HasSubstr("there are cD, wD, tkD"));
  EXPECT_THAT(sentence("GP(9,9)"), HasSubstr("at most 8"));
  EXPECT_EQ(find_arrangement("").error().exit_code, kUsage);
}

TEST(DesignFile, SetsTheDesign) {
  Design design;
  design.array = "wD-66";
  design.shield = {4.05, 9};
  design.removed_shields = {3, 7};
  design.sphere_mm = 36.25;
  EXPECT_EQ(parse_design(design_text(design), "x.json").value(), design);
  EXPECT_EQ(parse_design("{}", "x.json").value(), Design());
}

TEST(DesignFile, ErrorsNameTheKey) {
  const auto sentence = [](const std::string& text) {
    const auto design = parse_design(text, "x.json");
    EXPECT_EQ(design.error().exit_code, kBadData);
    return design.error().message;
  };
  EXPECT_EQ(sentence("[]"), "x.json:1: must be an object in braces, not a list");
  EXPECT_THAT(sentence("{"), HasSubstr("x.json:1: not valid JSON"));
  EXPECT_THAT(sentence("{}" + std::string(1, '\0') + "garbage"),
              HasSubstr("x.json:1: not valid JSON: has a NUL byte"));
  EXPECT_THAT(sentence(R"({"colour": 1})"),
              HasSubstr("colour: unknown key; there are array, positions, magnet, shield,"));
  EXPECT_THAT(sentence(R"({"a\u001b[2J": 1})"), HasSubstr("x.json:1: a\\u001b[2J: unknown key"));
  EXPECT_EQ(sentence("{\n\"aray\": \"tkD\"}"),
            "x.json:2: aray: unknown key; did you mean \"array\"?");
  EXPECT_THAT(sentence(R"({"sphere_mm": "35"})"),
              HasSubstr("sphere_mm: must be a number, 5 to 500, not \"35\""));
  EXPECT_THAT(sentence(R"({"magnet": "8"})"), HasSubstr("magnet: '8' is not a magnet"));
  EXPECT_THAT(sentence(R"({"magnet": "\u001b[2J"})"), HasSubstr("'\\u001b[2J' is not a magnet"));
  EXPECT_THAT(sentence(R"({"sphere_mm": "\u009b2J"})"), HasSubstr("not \"\\u009b2J\""));
  EXPECT_THAT(sentence(R"({"removed_pins": [-1]})"),
              HasSubstr("removed_pins: must be a list of ids"));
}

TEST(DesignFile, UnknownValuesAreErrorsOfTheFile) {
  const TemporaryFolder folder;
  for (const char* text : {R"({"array": "nope"})", R"({"removed_pins": [5000]})"}) {
    const std::string file = folder.write("b.json", text);
    const CommandResult result = run_design({"stability", file});
    EXPECT_EQ(result.exit_code, kBadData) << text;
    EXPECT_THAT(result.err, HasSubstr(file)) << text;
  }
  EXPECT_EQ(parse_design(R"({"removed_pins": [3, 3]})", "x").value().removed_pins,
            std::vector<int>{3});
  // A flag may replace any valid value of the file.
  EXPECT_EQ(run_design({"array", folder.write("c.json", R"({"array": "cD"})"), "--array", "wD"})
                .exit_code,
            0);
}

TEST(Positions, AreWrittenAndReadBack) {
  const auto array = find_arrangement("tkD-86").value();
  const auto again = parse_positions(positions_csv(array, Design().sizes()), "pins.csv").value();
  ASSERT_EQ(again.pins.size(), array.pins.size());
  ASSERT_EQ(again.shields.size(), array.shields.size());
  for (std::size_t i = 0; i < array.pins.size(); ++i) {
    EXPECT_EQ(again.pins[i].id, array.pins[i].id);
    EXPECT_LT(model::norm(again.pins[i].direction - array.pins[i].direction), 1e-7);
  }
}

TEST(Positions, MayBeInAnyOrderAndAfterAByteOrderMark) {
  const auto array = find_arrangement("wD-66").value();
  std::istringstream lines(positions_csv(array, Design().sizes()));
  std::string head;
  std::getline(lines, head);
  std::string turned;
  for (std::string line; std::getline(lines, line);) turned = line + "\n" + turned;
  const TemporaryFolder folder;
  const std::string csv = folder.write("turned.csv", "\xEF\xBB\xBF" + head + "\n" + turned);
  for (const int pin : {0, 25}) {
    const CommandResult result =
        run_design({"electromagnet", "--positions", csv, "--pin", std::to_string(pin), "--json"});
    ASSERT_EQ(result.exit_code, 0) << result.err;
    const CommandResult usual =
        run_design({"electromagnet", "--array", "wD-66", "--pin", std::to_string(pin), "--json"});
    EXPECT_EQ(result.json()["class_size"], usual.json()["class_size"]) << pin;
  }
  EXPECT_EQ(run_design({"stability", "--positions", csv, "--array", "cD"}).exit_code, kUsage);
}

TEST(Positions, ErrorsNameTheLine) {
  const auto sentence = [](const std::string& text) {
    const auto array = parse_positions(text, "p.csv");
    EXPECT_EQ(array.error().exit_code, kBadData) << text;
    return array.error().message;
  };
  EXPECT_THAT(sentence(""), HasSubstr("p.csv is empty"));
  EXPECT_THAT(sentence("\x7f"
                       "ELF\x01\x02"),
              HasSubstr("no CSV of positions"));
  EXPECT_THAT(sentence("a;b\n1;2\n"), HasSubstr("no CSV of positions"));
  EXPECT_THAT(sentence("kind,x,y,z\nshield,0,0,1\n"), HasSubstr("no pins"));
  EXPECT_THAT(sentence("kind,x,y,z\npin,0,0,1\npin,1,2\n"),
              HasSubstr("p.csv:3: has fewer columns"));
  EXPECT_THAT(sentence("kind,x,y,z\npin,0,zero,1\n"),
              HasSubstr("p.csv:2: x, y and z must be numbers"));
  EXPECT_THAT(sentence("kind,x,y,z\npin,0,0,0\n"), HasSubstr("no direction"));
  EXPECT_THAT(sentence("kind,x,y,z\npin,0,nan,1\n"), HasSubstr("p.csv:2"));
  EXPECT_THAT(sentence("kind,x,y,z\nrod,0,0,1\n"), HasSubstr("'rod' is neither"));
  EXPECT_THAT(sentence("kind,id,x,y,z\npin,1,0,0,1\npin,1,0,1,0\n"),
              HasSubstr("pin 1 was there before"));
}

}  // namespace
}  // namespace hedgehog::design
