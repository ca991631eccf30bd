// SPDX-License-Identifier: MIT
// The rules applied to this checkout.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/folders.h"
#include "tests/structure/rules.h"

namespace hedgehog::structure {
namespace {

using testing::IsEmpty;

class Tree : public testing::Test {
 protected:
  static const SourceTree& tree() {
    static const SourceTree kTree = read_tree(source_folder());
    return kTree;
  }

  /// REQUIRES: there is such a file.
  static const SourceFile& file_at(const std::string& path) {
    const auto& files = tree().files;
    return *std::find_if(files.begin(), files.end(),
                         [&](const SourceFile& one) { return one.path == path; });
  }

  template <typename Rule>
  static Violations check_all(Rule rule) {
    Violations all;
    for (const SourceFile& file : tree().files) {
      const Violations found = rule(file);
      all.insert(all.end(), found.begin(), found.end());
    }
    return all;
  }
};

TEST_F(Tree, IsRead) {
  EXPECT_THAT(tree().names, testing::Contains("CMakeLists.txt"));
  EXPECT_THAT(tree().names, testing::Contains("tests/structure/tree_test.cpp"));
  EXPECT_THAT(tree().names, testing::Not(testing::Contains(testing::StartsWith("build/"))));
}

TEST_F(Tree, IncludesFollowTheLayers) { EXPECT_THAT(check_all(check_layer_includes), IsEmpty()); }

TEST_F(Tree, LibrariesStayInTheirLayers) {
  EXPECT_THAT(check_all(check_library_includes), IsEmpty());
}

TEST_F(Tree, FilesAreShortAndLicensed) { EXPECT_THAT(check_all(check_file_shape), IsEmpty()); }

TEST_F(Tree, NamesNoPathOfThisMachine) { EXPECT_THAT(check_all(check_machine_paths), IsEmpty()); }

TEST_F(Tree, UsesItsUsingDeclarations) { EXPECT_THAT(check_all(check_using), IsEmpty()); }

TEST_F(Tree, IncludesNoSources) { EXPECT_THAT(check_all(check_included_sources), IsEmpty()); }

TEST_F(Tree, TestsOfAFolderShareNoName) { EXPECT_THAT(check_test_names(tree()), IsEmpty()); }

TEST_F(Tree, NamesAreTerms) { EXPECT_THAT(check_all(check_terms), IsEmpty()); }

TEST_F(Tree, LinksResolve) {
  EXPECT_THAT(check_all([](const SourceFile& file) { return check_links(file, tree()); }),
              IsEmpty());
}

/// The lines of the first block of code.
std::string first_commands(const SourceFile& readme) {
  std::string commands;
  for (const std::string& line : readme.lines)
    if (line.starts_with("    "))
      commands += line.substr(4) + "\n";
    else if (!commands.empty())
      break;
  return commands;
}

TEST_F(Tree, ReadmesOfTheServiceBeginWithItsCommands) {
  const SourceFile& daemon = file_at("daemon/README.md");
  const auto heading =
      std::find_if(daemon.lines.begin(), daemon.lines.end(),
                   [](const std::string& line) { return line.starts_with("## "); });
  ASSERT_NE(heading, daemon.lines.end());
  EXPECT_EQ(*heading, "## As a service");
  for (const char* readme : {"daemon/README.md", "systemd/README.md"})
    EXPECT_THAT(first_commands(file_at(readme)),
                testing::HasSubstr("systemctl enable --now hedgehogd\n"))
        << readme;
}

TEST_F(Tree, FoldersAreSmall) { EXPECT_THAT(check_folder_sizes(tree()), IsEmpty()); }

TEST_F(Tree, EveryFolderHasAReadme) { EXPECT_THAT(check_readmes(tree()), IsEmpty()); }

TEST_F(Tree, ReadmesAreOneScreen) { EXPECT_THAT(check_all(check_readme_size), IsEmpty()); }

}  // namespace
}  // namespace hedgehog::structure
