// SPDX-License-Identifier: MIT
// Tests of the rules: each must accept valid files and report invalid ones.
#include "tests/structure/rules.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace hedgehog::structure {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

SourceFile including(std::string path, const std::string& what) {
  return {std::move(path), {"// SPDX-License-Identifier: MIT", "#include " + what}};
}

Violations layer(const std::string& path, const std::string& what) {
  return check_layer_includes(including(path, what));
}

Violations library(const std::string& path, const std::string& what) {
  return check_library_includes(including(path, what));
}

TEST(LayerRule, FollowsTheArrows) {
  EXPECT_THAT(layer("model/a.h", "\"model/b.h\""), IsEmpty());
  EXPECT_THAT(layer("protocol/a.h", "\"model/b.h\""), IsEmpty());
  EXPECT_THAT(layer("daemon/control/a.h", "\"daemon/device/b.h\""), IsEmpty());
  EXPECT_THAT(layer("daemon/server/x/a.cpp", "\"daemon/config/b.h\""), IsEmpty());
  EXPECT_THAT(layer("emulator/a.cpp", "\"daemon/device/b.h\""), IsEmpty());
  EXPECT_THAT(layer("daemon/main.cpp", "\"daemon/server/b.h\""), IsEmpty());
  EXPECT_THAT(layer("clients/ctl/a.cpp", "\"clients/lib/b.h\""), IsEmpty());
  EXPECT_THAT(layer("tests/e2e/a.cpp", "\"clients/lib/b.h\""), IsEmpty());
  EXPECT_THAT(layer("clients/unreal/Source/a.h", "\"CoreMinimal.h\""), IsEmpty());
}

TEST(LayerRule, RejectsAnArrowBackwards) {
  EXPECT_THAT(layer("model/a.h", "\"protocol/b.h\""),
              ElementsAre("model/a.h:2: model may not include \"protocol/b.h\""));
  EXPECT_THAT(layer("daemon/device/a.h", "\"daemon/control/b.h\""), testing::SizeIs(1));
  EXPECT_THAT(layer("daemon/control/a.h", "\"protocol/b.h\""), testing::SizeIs(1));
  EXPECT_THAT(layer("daemon/config/a.h", "\"protocol/b.h\""), testing::SizeIs(1));
  EXPECT_THAT(layer("daemon/config/a.h", "\"base/keys/key.h\""), IsEmpty());
  EXPECT_THAT(layer("model/a.h", "\"base/keys/key.h\""), testing::SizeIs(1));
  EXPECT_THAT(layer("base/a.h", "\"base/keys/key.h\""), testing::SizeIs(1));
  EXPECT_THAT(layer("protocol/a.h", "\"daemon/control/b.h\""), testing::SizeIs(1));
  EXPECT_THAT(layer("clients/lib/a.h", "\"daemon/control/b.h\""), testing::SizeIs(1));
  EXPECT_THAT(layer("clients/ctl/a.h", "\"clients/orientation/b.h\""), testing::SizeIs(1));
  EXPECT_THAT(layer("daemon/device/board_core/a.h", "\"model/b.h\""), testing::SizeIs(1));
  EXPECT_THAT(layer("model/a.h", "\"tests/rig/b.h\""), testing::SizeIs(1));
}

TEST(LayerRule, RequiresIncludesFromTheRoot) {
  EXPECT_THAT(layer("model/a.cpp", "\"a.h\""), ElementsAre(HasSubstr("repository root")));
  EXPECT_THAT(layer("model/a.cpp", "\"../protocol/a.h\""), testing::SizeIs(1));
  EXPECT_THAT(layer("model/a.cpp", "<model/a.h>"), ElementsAre(HasSubstr("quotes")));
}

TEST(LibraryRule, RejectsJsonInHeaders) {
  EXPECT_THAT(library("protocol/a.h", "<nlohmann/json.hpp>"), testing::SizeIs(1));
  EXPECT_THAT(library("clients/lib/a.h", "<nlohmann/json_fwd.hpp>"), testing::SizeIs(1));
  EXPECT_THAT(library("protocol/a.cpp", "<nlohmann/json.hpp>"), IsEmpty());
}

TEST(LibraryRule, RejectsLibrariesInTheControlPath) {
  for (const char* folder : {"model", "daemon/device", "daemon/control", "tests/rig"}) {
    for (const char* header :
         {"<nlohmann/json.hpp>", "<boost/asio.hpp>", "<boost/asio/io_context.hpp>",
          "<spdlog/spdlog.h>", "<boost/beast/http.hpp>"}) {
      EXPECT_THAT(library(std::string(folder) + "/a.cpp", header), testing::SizeIs(1))
          << folder << " " << header;
    }
  }
  EXPECT_THAT(library("daemon/control/a.cpp", "<boost/lockfree/spsc_queue.hpp>"), IsEmpty());
  EXPECT_THAT(library("model/a.cpp", "<thread>"), testing::SizeIs(1));
}

TEST(LibraryRule, RequiresAFreestandingBoardCore) {
  EXPECT_THAT(library("daemon/device/board_core/a.h", "<stdint.h>"), IsEmpty());
  EXPECT_THAT(library("daemon/device/board_core/a.h", "<cstdint>"), testing::SizeIs(1));
  EXPECT_THAT(library("daemon/device/board_core/a.cpp", "<string.h>"), testing::SizeIs(1));
}

TEST(ShapeRule, RequiresLicenceGuardNameAndBrevity) {
  SourceFile file{"model/a.h", {"// SPDX-License-Identifier: MIT", "#pragma once"}};
  EXPECT_THAT(check_file_shape(file), IsEmpty());
  file.lines.resize(kMaxLines);
  EXPECT_THAT(check_file_shape(file), IsEmpty());
  file.lines.resize(kMaxLines + 1);
  EXPECT_THAT(check_file_shape(file), ElementsAre(HasSubstr("301 lines")));
  EXPECT_THAT(check_file_shape({"model/a.h", {"#pragma once"}}), ElementsAre(HasSubstr("SPDX")));
  EXPECT_THAT(check_file_shape({"model/a.h", {"// SPDX-License-Identifier: MIT"}}),
              ElementsAre(HasSubstr("#pragma once")));
  EXPECT_THAT(check_file_shape({"model/ThermalModel.cpp", {"// SPDX-License-Identifier: MIT"}}),
              ElementsAre(HasSubstr("snake_case")));
  EXPECT_THAT(check_file_shape({"x.sh", {"#!/bin/sh", "# SPDX-License-Identifier: MIT"}}),
              IsEmpty());
}

TEST(MachinePathRule, FindsOnlyWherePathsStart) {
  const std::string home = std::string("/ho") + "me/anna";
  EXPECT_THAT(check_machine_paths({"a.md", {"see " + home}}), testing::SizeIs(1));
  EXPECT_THAT(check_machine_paths({"a.cpp", {"\"" + home + "\""}}), testing::SizeIs(1));
  EXPECT_THAT(check_machine_paths({"a.md", {"see docs" + home, "/etc/hedgehog/"}}), IsEmpty());
}

TEST(UsingRule, RequiresAUseOfTheName) {
  EXPECT_THAT(check_using({"a.cpp", {"using b::C;", "C c;"}}), IsEmpty());
  EXPECT_THAT(check_using({"a.cpp", {"using b::C;", "Cc c;"}}),
              ElementsAre("a.cpp:1: nothing uses C"));
  EXPECT_THAT(check_using({"a.cpp", {"namespace fs = std::filesystem;"}}),
              ElementsAre("a.cpp:1: nothing uses fs"));
  EXPECT_THAT(check_using({"a.cpp", {"  using b::c;", "// c"}}),
              ElementsAre("a.cpp:1: nothing uses c"));
  EXPECT_THAT(check_using({"a.h", {"using b::C;"}}), IsEmpty());
}

TEST(TermRule, FindsWordsInNamesOnly) {
  const auto terms = [](const std::string& line) { return check_terms({"daemon/a.h", {line}}); };
  EXPECT_THAT(terms("bool toldAgain = isOwed(kMaxSaid_s);"), testing::SizeIs(3));
  EXPECT_THAT(terms("bool tell_all();"),
              ElementsAre("daemon/a.h:1: tell_all: not \"tell\" but print, publish, report"));
  EXPECT_THAT(terms("int retold = assaid(\"it is said\");  // as was told"), IsEmpty());
  EXPECT_THAT(terms(R"~(f(R"({"told":1})", tell);)~"), testing::SizeIs(1));
  EXPECT_THAT(check_terms({"tests/a.cpp", {"int told;"}}), testing::SizeIs(1));
  EXPECT_THAT(check_terms({"tests/a.sh", {"told=1"}}), IsEmpty());
}

TEST(IncludedSourceRule, FindsSourcesOnly) {
  EXPECT_THAT(check_included_sources({"a.cpp", {"#include \"b.cpp\""}}),
              ElementsAre("a.cpp:1: includes a source file"));
  EXPECT_THAT(check_included_sources({"a.cpp", {"#include \"b.h\"", "// b.cpp"}}), IsEmpty());
}

TEST(LinkRule, ResolvesRelativeToTheFile) {
  const SourceTree tree{{}, {"protocol"}, {"protocol/README.md"}};
  EXPECT_THAT(check_links({"README.md", {"[p](protocol/README.md#errors) [f](protocol/)"}}, tree),
              IsEmpty());
  EXPECT_THAT(check_links({"model/README.md", {"[p](../protocol/README.md)"}}, tree), IsEmpty());
  EXPECT_THAT(check_links({"model/README.md", {"[p](protocol/README.md)"}}, tree),
              ElementsAre(HasSubstr("leads nowhere")));
  EXPECT_THAT(check_links({"README.md", {"```", "[p](nowhere)", "```"}}, tree), IsEmpty());
}

TEST(MessageRule, FindsMessagesOfNoSource) {
  const SourceFile page{
      "a.md", {"| message | why |", "| `late: … ticks skipped` | |", "| `never said` | |"}};
  const SourceTree tree{
      {{"daemon/a.cpp", {"warn(\"late: {} tic\"", "     \"ks skipped\");"}}}, {}, {}};
  EXPECT_THAT(check_quoted_messages(page, tree),
              ElementsAre("a.md:3: no source says \"never said\""));
}

ProgramMessages program_of(std::vector<Unexplained> unexplained) {
  return {"daemon/", {"warn(", "Problem("}, "a.md", std::move(unexplained)};
}

TEST(MessageRule, RequiresARowForEachMessage) {
  SourceTree tree{
      {{"a.md", {"| message | why |", "| `late: … ticks skipped` | |", "| `busy` | |"}},
       {"daemon/a.cpp",
        {"warn(\"{}: late: {} tic\"", "     \"ks skipped\", name(';', '\"'), 1'000);",
         "return Problem{1, file + \": busy; \" + why};", "warn(\"{}: {}\", file, why);"}}},
      {},
      {}};
  EXPECT_THAT(check_explained_messages(program_of({}), tree),
              ElementsAre("daemon/a.cpp: no row of a.md explains \": busy; \""));
  EXPECT_THAT(check_explained_messages(program_of({{": busy; ", "a reason"}}), tree), IsEmpty());
  tree.files[0].lines.emplace_back("| `…: busy; …` | |");
  EXPECT_THAT(check_explained_messages(program_of({}), tree), IsEmpty());
}

TEST(MessageRule, FindsUnneededExceptions) {
  const SourceTree tree{
      {{"a.md", {"| `all is lost` | |"}}, {"daemon/a.cpp", {"warn(\"all is lost\");"}}}, {}, {}};
  EXPECT_THAT(check_explained_messages(program_of({{"all is well", "a reason"}}), tree),
              ElementsAre("daemon/: no source says \"all is well\", which is listed as unexplained",
                          "daemon/: no message begins with Problem("));
}

TEST(MessageRule, RequiresARowForEachErrorOfTheProtocol) {
  const SourceFile errors{"error.cpp",
                          {"case ErrorCode::kBusy:", "  return \"busy\";",
                           "case ErrorCode::kArmed:", "  return \"armed\";"}};
  EXPECT_THAT(check_explained_errors(errors, {"a.md", {"| `busy` | |", "| `not armed` | |"}}),
              ElementsAre("error.cpp:4: no row of a.md explains armed"));
  EXPECT_THAT(check_explained_errors({"error.cpp", {}}, {"a.md", {}}),
              ElementsAre("error.cpp: names no error"));
}

TEST(ReadmeRule, ChecksTopLevelFoldersAndLayers) {
  const SourceTree tree{{},
                        {"cmake", "cmake/apt", "daemon", "daemon/device", "tests", "tests/bench"},
                        {"daemon/README.md", "daemon/device/CMakeLists.txt", "tests/README.md",
                         "tests/bench/CMakeLists.txt"}};
  EXPECT_THAT(check_readmes(tree),
              ElementsAre("cmake: no README.md", "daemon/device: no README.md"));
}

TEST(ReadmeRule, LimitsTheLinesOfThoseOfFolders) {
  const std::vector<std::string> screen(60), longer(61);
  EXPECT_THAT(check_readme_size({"daemon/README.md", screen}), IsEmpty());
  EXPECT_THAT(check_readme_size({"daemon/README.md", longer}),
              ElementsAre("daemon/README.md: has 61 lines, more than 60"));
  for (const char* path : {"README.md", "protocol/README.md", "daemon/access.md"})
    EXPECT_THAT(check_readme_size({path, longer}), IsEmpty()) << path;
}

TEST(FolderSizeRule, CountsTheSourcesOfEachFolderOfTheProduct) {
  SourceTree tree;
  const auto add = [&](const std::string& folder, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i)
      tree.names.push_back(folder + "/file" + std::to_string(i) + (i % 2 == 0 ? ".cpp" : ".h"));
  };
  add("daemon/server", 24);
  add("daemon/server/net", 24);
  add("tests/e2e", 40);
  tree.names.emplace_back("daemon/server/README.md");
  EXPECT_THAT(check_folder_sizes(tree), IsEmpty());
  tree.names.emplace_back("daemon/server/one_more.h");
  EXPECT_THAT(check_folder_sizes(tree),
              ElementsAre("daemon/server: has 25 files in C++, more than 24"));
}

SourceFile test_with(std::string path, const std::string& line, const std::string& in = "a") {
  return {std::move(path), {"namespace " + in + " {", "namespace {", line, "}", "}"}};
}

TEST(TestNameRule, RejectsASecondOneOfANameInTheNamespace) {
  const SourceFile one = test_with("tests/x/a_test.cpp", "constexpr double kS = 0.1;");
  for (const char* line : {"constexpr int kS = 2;", "constexpr std::array<int, 2> kS{1, 2};",
                           "constexpr int kS[] = {1};", "static constexpr double kS = 0.1;"}) {
    EXPECT_THAT(check_test_names({{one, test_with("tests/x/y/b_test.cpp", line)}, {}, {}}),
                ElementsAre("tests/x/y/b_test.cpp: kS is in tests/x/a_test.cpp too"));
  }
}

TEST(TestNameRule, RejectsASecondTypeAndFunction) {
  for (const char* line : {"struct Case {", "class Case : public Test {", "int f(int a) {"}) {
    EXPECT_THAT(check_test_names(
                    {{test_with("tests/x/a_test.cpp", line), test_with("tests/x/b_test.cpp", line)},
                     {},
                     {}}),
                testing::SizeIs(1))
        << line;
  }
}

TEST(TestNameRule, AcceptsOtherFoldersNamespacesAndScopes) {
  const SourceFile one = test_with("tests/x/a_test.cpp", "constexpr double kS = 0.1;");
  for (const SourceFile& other : {test_with("tests/z/b_test.cpp", one.lines[2]),
                                  test_with("tests/x/b_test.cpp", one.lines[2], "b"),
                                  test_with("tests/x/b_test.cpp", "  " + one.lines[2]),
                                  test_with("tests/x/b_test.cpp", "constexpr int kT = f(kS);"),
                                  test_with("x/b.cpp", one.lines[2])})
    EXPECT_THAT(check_test_names({{one, other}, {}, {}}), IsEmpty()) << other.path;
}

}  // namespace
}  // namespace hedgehog::structure
