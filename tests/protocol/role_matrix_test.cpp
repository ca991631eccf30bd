// SPDX-License-Identifier: MIT
// The table of roles and methods in protocol/README.md is generated from the methods' structs.
// HEDGEHOG_WRITE_SCHEMA=1 rewrites it.
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string>

#include "protocol/methods.h"
#include "tests/folders.h"

namespace hedgehog::protocol {
namespace {

constexpr const char* kBegin = "| method | no token | `observe` | `play` | `operate` |\n";

std::string matrix() {
  std::string text = kBegin;
  text += "|---|---|---|---|---|\n";
  for (const MethodInfo& method : kMethods) {
    text += "| `" + std::string(method.name) + "` | ";
    text += method.name == Hello::kMethod.name ? "with a token" : "–";
    for (const Role role : {Role::kObserve, Role::kPlay, Role::kOperate})
      text += !method.role || role >= *method.role ? " | yes" : " | –";
    text += " |\n";
  }
  return text;
}

std::string read(const std::string& path) {
  std::ifstream in(path);
  std::stringstream text;
  text << in.rdbuf();
  return text.str();
}

TEST(Schema, TheDocumentHasTheRolesOfEachMethod) {
  const std::string path = source_folder() + "/protocol/README.md";
  std::string text = read(path);
  const std::size_t begin = text.find(kBegin);
  ASSERT_NE(begin, std::string::npos);
  const std::size_t end = text.find("\n\n", begin) + 1;
  if (std::getenv("HEDGEHOG_WRITE_SCHEMA") != nullptr) {
    text.replace(begin, end - begin, matrix());
    std::ofstream(path) << text;
  } else {
    EXPECT_EQ(text.substr(begin, end - begin), matrix())
        << "HEDGEHOG_WRITE_SCHEMA=1 test_protocol --gtest_filter='Schema.*' rewrites it";
  }
}

}  // namespace
}  // namespace hedgehog::protocol
