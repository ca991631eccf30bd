// SPDX-License-Identifier: MIT
// The rules applied to this checkout.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/structure/rules.h"

namespace hedgehog::structure {
namespace {

using testing::IsEmpty;

class Tree : public testing::Test {
 protected:
  static const SourceTree& tree() {
    static const SourceTree kTree = read_tree(HEDGEHOG_SOURCE_DIR);
    return kTree;
  }

  template <typename Rule>
  static Violations everywhere(Rule rule) {
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

TEST_F(Tree, IncludesFollowTheLayers) { EXPECT_THAT(everywhere(check_layer_includes), IsEmpty()); }

TEST_F(Tree, LibrariesStayInTheirLayers) {
  EXPECT_THAT(everywhere(check_library_includes), IsEmpty());
}

TEST_F(Tree, FilesAreShortAndLicensed) { EXPECT_THAT(everywhere(check_file_shape), IsEmpty()); }

TEST_F(Tree, NamesNoMachine) { EXPECT_THAT(everywhere(check_machine_paths), IsEmpty()); }

TEST_F(Tree, UsesWhatItBringsIn) { EXPECT_THAT(everywhere(check_using), IsEmpty()); }

TEST_F(Tree, IncludesNoSources) { EXPECT_THAT(everywhere(check_included_sources), IsEmpty()); }

TEST_F(Tree, NamesAreTerms) { EXPECT_THAT(everywhere(check_terms), IsEmpty()); }

TEST_F(Tree, LinksLeadSomewhere) {
  EXPECT_THAT(everywhere([](const SourceFile& file) { return check_links(file, tree()); }),
              IsEmpty());
}

TEST_F(Tree, EveryFolderHasAReadme) { EXPECT_THAT(check_readmes(tree()), IsEmpty()); }

}  // namespace
}  // namespace hedgehog::structure
