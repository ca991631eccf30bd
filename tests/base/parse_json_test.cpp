// SPDX-License-Identifier: MIT
#include "base/parse_json.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

namespace hedgehog::base {
namespace {

using nlohmann::json;
using nlohmann::ordered_json;
using testing::StartsWith;

TEST(ParseJson, GivesTheTreeOfTheLibrary) {
  const auto parsed = parse_json<ordered_json>(R"({"b": 1, "a": "x\u0000y"})");
  ASSERT_TRUE(parsed.good());
  EXPECT_EQ(parsed.value.dump(), R"({"b":1,"a":"x\u0000y"})");
  EXPECT_TRUE(parse_json<json>(" null ").value.is_null());
}

TEST(ParseJson, ANulEndsNoText) {
  const std::string good = R"({"a": 1})";
  for (const std::string& text :
       {good + '\0', good + '\0' + "garbage", good.substr(0, 2) + '\0' + good.substr(2)}) {
    const auto parsed = parse_json<json>(text);
    EXPECT_TRUE(parsed.value.is_discarded());
    EXPECT_EQ(parsed.problem, "has a NUL byte, which JSON never has");
    EXPECT_EQ(parsed.at, text.find('\0'));
  }
}

TEST(ParseJson, ReportsPositionAndErrorAndThrowsNothing) {
  const auto parsed = parse_json<json>("{\n\"a\" 1}");
  EXPECT_TRUE(parsed.value.is_discarded());
  EXPECT_EQ(parsed.at, 7u);
  EXPECT_THAT(parsed.problem, StartsWith("parse error at line 2, column 5: syntax error"));
  for (const char* text :
       {"", "{", "[1,]", "{} {}", "\xff", "\"\xff\"", "1e999", "[-1e999]", "nul"})
    EXPECT_FALSE(parse_json<json>(text).good()) << text;
  EXPECT_EQ(parse_json<json>("[\n1e999]").at, 7u) << "a number that no double can hold";
}

TEST(ParseJson, AcceptsCommentsWhereTheyAreAllowed) {
  const std::string text = "{ // so\n}";
  EXPECT_FALSE(parse_json<json>(text).good());
  EXPECT_TRUE(parse_json<json>(text, JsonComments::kAllowed).good());
}

}  // namespace
}  // namespace hedgehog::base
