// SPDX-License-Identifier: MIT
// Each installed program has a man page and completions with all options of its --help.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <regex>
#include <set>
#include <string>

#include "tests/e2e/daemon_process.h"
#include "tests/e2e/program.h"
#include "tests/e2e/programs.h"

namespace hedgehog::e2e {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

/// Options such as "--listen" in a program's help, without those that every program has.
std::set<std::string> options_of(const std::string& help) {
  static const std::regex option(R"((^|[ ,])(--[a-z][a-z-]*))");
  std::set<std::string> found;
  for (std::sregex_iterator at(help.begin(), help.end(), option), end; at != end; ++at)
    found.insert((*at)[2]);
  found.erase("--help");
  return found;
}

std::string man_page_of(const Home& home, const std::string& name) {
  for (const char* section : {"1", "8"}) {
    const std::string page = std::string("share/man/man") + section + "/" + name + "." + section;
    if (fs::exists(home.path(page))) return home.read(page);
  }
  return "";
}

std::string without_escapes(std::string page) {
  page.erase(std::remove(page.begin(), page.end(), '\\'), page.end());
  return page;
}

TEST(Reference, EachInstalledProgramHasIt) {
  const Home home;
  const auto programs = installed_programs();
  ASSERT_GE(programs.size(), 7U);
  for (const std::string& program : programs) {
    const std::string name = fs::path(program).filename();
    SCOPED_TRACE(name);
    const Ended written = Program(home, program, {"--reference", home.path("share")}).wait();
    ASSERT_EQ(written.exit_code, 0) << written.err;
    const std::string page = without_escapes(man_page_of(home, name));
    EXPECT_THAT(page, HasSubstr(".SH NAME\n" + name + " - "));
    const std::string bash = home.read("share/bash-completion/completions/" + name);
    const std::string zsh = home.read("share/zsh/site-functions/_" + name);
    const std::string fish = home.read("share/fish/vendor_completions.d/" + name + ".fish");
    const auto options = options_of(Program(home, program, {"--help"}).wait().out);
    EXPECT_THAT(options, testing::Contains("--version"));
    for (const std::string& option : options) {
      EXPECT_THAT(page, HasSubstr(option));
      EXPECT_THAT(bash, HasSubstr(option));
      EXPECT_THAT(zsh, HasSubstr(option));
      EXPECT_THAT(fish, HasSubstr(" -l " + option.substr(2)));
    }
  }
}

TEST(Reference, EachManPageNamesTheOtherPrograms) {
  const Home home;
  for (const std::string& program : installed_programs()) {
    Program(home, program, {"--reference", home.path("share")}).wait();
    const std::string name = fs::path(program).filename();
    const std::string page = without_escapes(man_page_of(home, name));
    const std::string also = page.substr(std::min(page.find("SEE ALSO"), page.size()));
    for (const std::string& other : installed_programs())
      if (other != program)
        EXPECT_THAT(also, HasSubstr(fs::path(other).filename().string() + "(")) << name;
  }
}

}  // namespace
}  // namespace hedgehog::e2e
