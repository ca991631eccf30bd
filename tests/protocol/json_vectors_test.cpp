// SPDX-License-Identifier: MIT
// Texts that are JSON and texts that are not, by RFC 8259 section after section, with the
// restrictions of I-JSON (RFC 7493); the result of parse_json for each. Written from the two
// documents.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <string_view>

#include "protocol/wire/json.h"

namespace hedgehog::protocol {
namespace {

using namespace std::string_view_literals;

constexpr std::size_t kVectorLevels = 32;

bool is_json(std::string_view text) { return parse_json(text, kVectorLevels).has_value(); }

TEST(JsonVectors, ValidTextsAreRead) {
  for (const std::string_view text :
       {// Section 2: any value is a text, white space around every token.
        "null"sv, "true"sv, "false"sv, "0"sv, "\"\""sv, "[]"sv, "{}"sv, " \t\n\r[ \t\n\r] \t\n\r"sv,
        "{ \"a\" : [ 1 , 2 ] }"sv, "\n{\n}\n"sv,
        // Section 4: a name may be empty, escaped, long, or differ from another only in its case.
        R"({"":0})"sv, R"({"a":{"a":0}})"sv, R"({"a":1,"A":2})"sv, R"({"\u0000":0})"sv,
        R"({"a\nb":{}})"sv,
        // Section 5.
        "[[],[[]],{}]"sv, "[null,1,\"1\",{}]"sv,
        // Section 6.
        "-0"sv, "-1"sv, "10"sv, "0.5"sv, "-0.0"sv, "1e1"sv, "1E+1"sv, "1e-1"sv, "0e1"sv, "0e+1"sv,
        "123.456e-789"sv, "1.7976931348623157e308"sv, "-9007199254740992"sv,
        "123456789012345678901234567890"sv,
        // Section 7.
        R"("\" \\ \/ \b \f \n \r \t")"sv, R"("\u0041\u00e9\u20AC")"sv, R"("\ud834\udd1e")"sv,
        R"("\u0000")"sv, R"("\uFFFE\uFDD0")"sv, "\"\x7f\""sv, "\"\xe2\x80\xa8\xe2\x80\xa9\""sv,
        "\"/\""sv,
        // Section 8.1: UTF-8 of two, three and four bytes, up to the last code point.
        "\"\xc2\x80\xdf\xbf\""sv, "\"\xe0\xa0\x80\xef\xbf\xbf\""sv,
        "\"\xf0\x90\x80\x80\xf4\x8f\xbf\xbf\""sv})
    EXPECT_TRUE(is_json(text)) << text;
}

TEST(JsonVectors, InvalidStructureIsRefused) {
  for (const std::string_view text : {""sv,
                                      " "sv,
                                      "["sv,
                                      "]"sv,
                                      "{"sv,
                                      "}"sv,
                                      "[1"sv,
                                      "[1,"sv,
                                      "[,1]"sv,
                                      "[1,]"sv,
                                      "[1,,2]"sv,
                                      "[,]"sv,
                                      "[1 2]"sv,
                                      "[1]]"sv,
                                      "[1}"sv,
                                      "{]"sv,
                                      "{}}"sv,
                                      "{} {}"sv,
                                      "[] x"sv,
                                      "1 2"sv,
                                      "[]#"sv,
                                      "[1:2]"sv,
                                      R"({"a"})"sv,
                                      R"({"a":})"sv,
                                      R"({:1})"sv,
                                      R"({"a":1,})"sv,
                                      R"({"a":1,,"b":2})"sv,
                                      R"({,"a":1})"sv,
                                      R"({"a" 1})"sv,
                                      R"({"a"::1})"sv,
                                      R"({"a","b"})"sv,
                                      R"({"a":1 "b":2})"sv,
                                      R"({a:1})"sv,
                                      R"({1:1})"sv,
                                      R"({null:1})"sv,
                                      R"({[]:1})"sv,
                                      R"({'a':1})"sv,
                                      R"({"a":1)"sv,
                                      R"({"a":)"sv,
                                      R"({"a)"sv,
                                      "<null>"sv,
                                      "[\"a\",\n4,\n1"sv,
                                      "(1)"sv,
                                      "[1;2]"sv})
    EXPECT_FALSE(is_json(text)) << text;
}

TEST(JsonVectors, OnlyThreeNamesInLowerCaseAreValues) {
  for (const std::string_view text :
       {"nul"sv, "nulls"sv, "True"sv, "FALSE"sv, "tru"sv, "undefined"sv, "NaN"sv, "-NaN"sv,
        "Infinity"sv, "-Infinity"sv, "[nan]"sv, "[inf]"sv, "a"sv})
    EXPECT_FALSE(is_json(text)) << text;
}

TEST(JsonVectors, NumbersHaveOneForm) {
  for (const std::string_view text : {"+1"sv,          "-"sv,
                                      "--1"sv,         "01"sv,
                                      "-01"sv,         "00"sv,
                                      ".5"sv,          "-.5"sv,
                                      "1."sv,          "1.e1"sv,
                                      "1e"sv,          "1e+"sv,
                                      "1E-"sv,         "1e1.5"sv,
                                      "0x10"sv,        "1_000"sv,
                                      "1,5"sv,         "1 000"sv,
                                      "1a"sv,          "- 1"sv,
                                      "1e 1"sv,        "\xd9\xa1"sv /* ١ */,
                                      "\xef\xbc\x91"sv /* １ */})
    EXPECT_FALSE(is_json(text)) << text;
  for (const std::string_view beyond : {"1e309"sv, "-1e309"sv, "[1e99999]"sv})
    EXPECT_FALSE(is_json(beyond)) << beyond << " is more than a double holds";
}

TEST(JsonVectors, NumbersKeepTheirValue) {
  EXPECT_EQ(*parse_json("-9223372036854775808", kVectorLevels)->as<std::int64_t>(), INT64_MIN);
  EXPECT_EQ(*parse_json("9223372036854775807", kVectorLevels)->as<std::int64_t>(), INT64_MAX);
  EXPECT_EQ(*parse_json("9223372036854775808", kVectorLevels)->as<double>(), 0x1p63);
  EXPECT_EQ(*parse_json("123.456e-789", kVectorLevels)->as<double>(), 0.0)
      << "too small is nothing";
  EXPECT_TRUE(std::signbit(*parse_json("-0.0", kVectorLevels)->as<double>()));
}

TEST(JsonVectors, AnEscapedNameIsTheSameName) {
  for (const std::string_view value : {R"(0)"sv,
                                       R"(-0)"sv,
                                       R"(-0.0)"sv,
                                       R"(17)"sv,
                                       R"(999999999999999999)"sv,
                                       R"(1000000000000000000)"sv,
                                       R"(18446744073709551615)"sv,
                                       R"(0.1)"sv,
                                       R"(-1.5E+3)"sv,
                                       R"(1e-400)"sv,
                                       R"(4.9e-324)"sv,
                                       R"(1.7976931348623157e308)"sv,
                                       R"(123456789012345678901234567890.5)"sv,
                                       R"(true)"sv,
                                       R"(false)"sv,
                                       R"(null)"sv,
                                       R"("")"sv,
                                       R"("a b~")"sv,
                                       R"("é")"sv,
                                       R"([])"sv,
                                       R"([1,[2,[]],{}])"sv,
                                       R"({})"sv,
                                       R"({"a":1,"b":{"a":[null]}})"sv}) {
    const auto plain = parse_json("{\"v\":" + std::string(value) + " }", kVectorLevels);
    const auto escaped = parse_json("{\"\\u0076\":" + std::string(value) + " }", kVectorLevels);
    ASSERT_TRUE(plain && escaped) << value;
    EXPECT_EQ(to_text(*plain), to_text(*escaped)) << value;
    EXPECT_EQ(plain->find("v")->value.index(), escaped->find("v")->value.index()) << value;
  }
}

TEST(JsonVectors, AnObjectOfManyMembersHasEachOnce) {
  std::string text = "{";
  for (int i = 0; i < 100; ++i) text += "\"m" + std::to_string(i) + "\":" + std::to_string(i) + ',';
  EXPECT_TRUE(is_json(text + "\"m100\":0}"));
  EXPECT_FALSE(is_json(text + "\"m99\":0}"));
  EXPECT_FALSE(is_json(R"({"a":0,"a":0})"));
}

TEST(JsonVectors, StringsEscapeWhatTheyMust) {
  for (const std::string_view text :
       {"\""sv,      "\"a"sv,         "\"a\\\""sv,    "a\""sv,         "'a'"sv,     "\"\n\""sv,
        "\"\t\""sv,  "\"\r\""sv,      "\"\x01\""sv,   "\"\x1f\""sv,    R"("\a")"sv, R"("\x41")"sv,
        R"("\'")"sv, R"("\U0041")"sv, R"("\u004")"sv, R"("\u00G1")"sv, R"("\u")"sv, R"("\)"sv,
        R"("\ ")"sv, R"("\0")"sv,     "[\"a\x00\"]"sv})
    EXPECT_FALSE(is_json(text)) << text;
}

TEST(JsonVectors, SurrogatesComeInPairs) {
  for (const std::string_view text :
       {R"("\ud834")"sv, R"("\udd1e")"sv, R"("\udd1e\ud834")"sv, R"("\ud834\ud834")"sv,
        R"("\ud834\u0041")"sv, R"("\ud834a")"sv, R"("\ud834\n")"sv, R"({"\udc00":0})"sv})
    EXPECT_FALSE(is_json(text)) << text;
}

TEST(JsonVectors, TextIsUtf8) {
  for (const std::string_view bytes :
       {"\x80"sv, "\xbf"sv, "\xc3"sv, "\xc3\x28"sv, "\xc0\x80"sv, "\xc1\xbf"sv, "\xe0\x9f\xbf"sv,
        "\xe2\x82"sv, "\xed\xa0\x80"sv, "\xed\xbf\xbf"sv, "\xf0\x8f\xbf\xbf"sv,
        "\xf4\x90\x80\x80"sv, "\xf5\x80\x80\x80"sv, "\xf8\x88\x80\x80\x80"sv, "\xfe"sv, "\xff"sv,
        "\xe9"sv /* Latin-1 */}) {
    EXPECT_FALSE(is_json("\"" + std::string(bytes) + "\""));
    EXPECT_FALSE(is_json(bytes));
  }
  EXPECT_FALSE(is_json("\xff\xfe[\0]\0"sv)) << "UTF-16";
  EXPECT_FALSE(is_json("\0[\0]"sv)) << "UTF-16 without a mark";
  EXPECT_FALSE(is_json("\xef\xbb"sv)) << "half a byte order mark";
}

TEST(JsonVectors, OnlyFourCharactersAreWhiteSpace) {
  for (const std::string_view space : {"\x0b"sv, "\x0c"sv, "\xc2\xa0"sv, "\xe2\x81\xa0"sv,
                                       "\xe2\x80\xa8"sv, "\x1f"sv, "/**/"sv, "//\n"sv, "#\n"sv}) {
    EXPECT_FALSE(is_json("[" + std::string(space) + "]"));
    EXPECT_FALSE(is_json("[]" + std::string(space)));
  }
}

TEST(JsonVectors, ANulEndsNothing) {
  for (const std::string_view text :
       {"[]\0"sv, "[]\0x"sv, "[\0]"sv, "\0[]"sv, "[1\0]"sv, "1\0"sv, "true\0"sv,
        "{\"a\":1}\0{\"a\":2}"sv, "{\"a\0\":1}"sv, "\0"sv, "[] \0"sv}) {
    EXPECT_FALSE(is_json(text));
    EXPECT_NE(parse_json(text, kVectorLevels).error().message.find("NUL at byte"),
              std::string::npos);
  }
}

TEST(JsonVectors, ANameIsUniqueInAnObject) {
  for (const std::string_view text : {R"({"a":1,"a":1})"sv, R"({"a":1,"b":2,"a":3})"sv,
                                      R"({"a":1,"\u0061":2})"sv, R"([{"":0,"":0}])"sv})
    EXPECT_FALSE(is_json(text)) << text;
  EXPECT_TRUE(is_json(R"([{"a":1},{"a":1}])"));
}

}  // namespace
}  // namespace hedgehog::protocol
