// SPDX-License-Identifier: MIT
// The man page of a command line, checked by groff.
#include "cli/reference.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/cli/reference_files.h"

namespace hedgehog::cli {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST_F(Reference, IsWrittenForNothingElse) {
  const SampleApp sample;
  EXPECT_EQ(write_reference(sample.app, {"push", "left"}), std::nullopt);
  EXPECT_EQ(write_reference(sample.app, {"--reference", "/dev/null/nowhere"}), 73);
}

TEST_F(Reference, TheManPageHasAllAndGroffWarnsOfNothing) {
  const std::string page = text("man/man1/sample.1");
  for (const char* expected :
       {".TH SAMPLE 1", "sample \\- pushes", ".SS \"push \\fIside\\fR\"", "\\fB\\-\\-address\\fR",
        "\\fB\\-\\-shape\\fR \\fIsine|square\\fR", "\\&.how it rises", "back\\eslash",
        "SAMPLE_ADDRESS", "Options as of \\fBpush\\fR", "Exit: 0 done, 64 usage."})
    EXPECT_THAT(page, HasSubstr(expected));
  for (const char* hidden : {"secret", "hidden", "\\\\-help"})
    EXPECT_THAT(page, Not(HasSubstr(hidden)));
  if (!has("groff")) GTEST_SKIP() << "groff is not installed";
  EXPECT_EQ(shell("groff -man -ww -z -Tutf8 '" + path("man/man1/sample.1") + "'"), "");
  EXPECT_THAT(shell("groff -man -ww -Tascii -P-cbou '" + path("man/man1/sample.1") + "'"),
              HasSubstr("which \"side\" it's on"));
}

}  // namespace
}  // namespace hedgehog::cli
