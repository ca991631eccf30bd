// SPDX-License-Identifier: MIT
// protocol/README.md against the code, without a daemon: every request decodes as its response
// shows, every response obeys its schema, everything that exists is documented.
#include <gtest/gtest.h>

#include <array>
#include <fstream>
#include <functional>
#include <map>
#include <regex>
#include <set>
#include <sstream>

#include "protocol/server_codec.h"
#include "protocol/values/event.h"
#include "tests/folders.h"
#include "tests/model/direction_named.h"
#include "tests/protocol/example_file.h"
#include "tests/protocol/random_request.h"
#include "tests/protocol/schema.h"

namespace hedgehog::protocol {
namespace {

std::string readme() {
  std::ifstream in(source_folder() + "/protocol/README.md");
  std::stringstream text;
  text << in.rdbuf();
  return text.str();
}

class Readme : public testing::Test {
 protected:
  std::vector<Example> examples_ = protocol_examples(source_folder());
  Json messages_ = messages_schema();
};

TEST_F(Readme, HasExamplesWithRequestAndResponse) {
  EXPECT_GE(examples_.size(), 20u);
  for (const Example& example : examples_) {
    ASSERT_FALSE(example.lines.empty());
    EXPECT_TRUE(example.lines.front().sent) << "line " << example.lines.front().number;
  }
}

TEST_F(Readme, EveryMethodHasAnExampleAndEveryParameterIsNamed) {
  const std::string text = readme();
  std::set<Method> shown;
  for (const Example& example : examples_) {
    for (const ExampleLine& line : example.lines) {
      for (const Item& item : line.sent ? decode_line(line.text).items : std::vector<Item>{})
        if (item.method) shown.insert(*item.method);
    }
  }
  for (const MethodInfo& row : kMethods) {
    const Method method = *method_named(row.name);
    EXPECT_TRUE(shown.contains(method)) << row.name;
    for (const std::string& parameter : parameter_names(method))
      EXPECT_NE(text.find("`" + parameter + "`"), std::string::npos) << row.name << parameter;
  }
  for (const std::string_view type : kEventTypes)
    EXPECT_NE(text.find("`" + std::string(type) + "`"), std::string::npos) << type;
  for (const std::string_view key : kStatusKeyNames)
    EXPECT_NE(text.find("`" + std::string(key) + "`"), std::string::npos) << key;
}

/// The required form of a response, by the text of its id.
void check_response(const Json& messages, const Json& response,
                    const std::map<std::string, Item>& requests, int line) {
  const Json* id = response.find("id");
  ASSERT_NE(id, nullptr) << line;
  const auto found = requests.find(to_text(*id));
  ASSERT_NE(found, requests.end()) << "nobody asked, line " << line;
  const Item& item = found->second;
  if (const Json* error = response.find("error")) {
    EXPECT_EQ(violation(messages, "Error", *error), "") << line;
    if (!item.request) {
      EXPECT_EQ(mismatch(to_text(response), encode_error(*item.id, item.request.error())), "")
          << line;
    }
    return;
  }
  ASSERT_TRUE(item.request.has_value()) << line << ": " << item.request.error().message;
  EXPECT_EQ(violation(messages, result_name(*item.method), *response.find("result")), "") << line;
}

TEST_F(Readme, ResponsesConformToTheCodeAndTheSchema) {
  for (const Example& example : examples_) {
    std::map<std::string, Item> requests;
    for (const ExampleLine& line : example.lines) {
      if (line.sent) {
        for (Item& item : decode_line(line.text).items) {
          if (item.request && item.id) {
            const auto json = parse_json(line.text, kMaxNesting);
            const bool batch = json->as<Json::List>() != nullptr;
            EXPECT_EQ(batch ? "" : violation(messages_, "Request", *json), "") << line.number;
          }
          if (item.id)
            requests.insert_or_assign(item.id->json, std::move(item));
          else
            EXPECT_TRUE(item.request.has_value()) << "line " << line.number;
        }
        continue;
      }
      const Result<Json> json = parse_json(line.text, 64);
      ASSERT_TRUE(json.has_value()) << "line " << line.number;
      if (json->find("method") != nullptr)
        EXPECT_EQ(violation(messages_, "Notification", *json), "") << line.number;
      else if (const auto* batch = json->as<Json::List>())
        for (const Json& one : *batch) check_response(messages_, one, requests, line.number);
      else
        check_response(messages_, *json, requests, line.number);
    }
  }
}

/// One row of the table of equivalents: "(1, 0, 0) → [0, -1, 0] right".
TEST_F(Readme, EquivalentsMatchTheirTestVectors) {
  using Vector = std::array<double, 3>;
  using Formula = std::function<Vector(const Vector&)>;
  const std::map<std::string, Formula> formulas{{"[z, -x, y]",
                                                 [](const Vector& v) {
                                                   return Vector{v[2], -v[0], v[1]};
                                                 }},
                                                {"[-z, -x, y]",
                                                 [](const Vector& v) {
                                                   return Vector{-v[2], -v[0], v[1]};
                                                 }},
                                                {"[x, -y, z]",
                                                 [](const Vector& v) {
                                                   return Vector{v[0], -v[1], v[2]};
                                                 }},
                                                {"[x, y, z]", [](const Vector& v) { return v; }},
                                                {"[-y, -x, 0]", [](const Vector& v) {
                                                   return Vector{-v[1], -v[0], 0.0};
                                                 }}};
  const std::regex row(R"(\| `(\[[-xyz0, ]+\])` \| \((.*)\) → (\[.*\]) (\w+) \|)");
  const std::string text = readme();
  int rows = 0;
  for (std::sregex_iterator it(text.begin(), text.end(), row), end; it != end; ++it, ++rows) {
    const std::smatch& match = *it;
    const auto vectors = parse_json("[" + match[2].str() + "]", 2)->value;
    Vector from{};
    for (std::size_t i = 0; i < from.size(); ++i)
      from[i] = static_cast<double>(*std::get<Json::List>(vectors)[i].as<std::int64_t>());
    const Vector to = formulas.at(match[1].str())(from);
    std::string written = "[";
    for (const double part : to) {
      written += written.size() > 1 ? ", " : "";
      append_number(written, part);
    }
    EXPECT_EQ(written + "]", match[3].str()) << match[0];
    EXPECT_EQ(model::direction_named(match[4].str()), (model::Vec3{to[0], to[1], to[2]}))
        << match[0];
  }
  EXPECT_EQ(rows, 5);
  for (const double azimuth_deg : {-9000 / 100.0, -0x4000 * 360.0 / 65536, -90.0}) {
    const model::Vec3 right = model::vector_of({azimuth_deg, 0});
    EXPECT_NEAR(right.y, -1.0, 1e-12) << "SDL's east, evdev's 0x4000 and the compass' 90";
  }
}

TEST(ExampleMatching, WildcardsStandForAnythingAndNothingElseDoes) {
  EXPECT_EQ(mismatch(R"({"a":"…","b":1})", R"({"b":1.0,"a":[{}]})"), "");
  EXPECT_EQ(mismatch(R"({"a":1,"…":"…"})", R"({"a":1,"b":2})"), "");
  EXPECT_EQ(mismatch(R"([1,"…"])", "[1,2,3]"), "");
  EXPECT_EQ(mismatch(R"(["…","…"])", "[1,2]"), "");
  EXPECT_EQ(mismatch("0.0616", "0.0616"), "");
  EXPECT_NE(mismatch(R"({"a":1})", R"({"a":1,"b":2})"), "");
  EXPECT_NE(mismatch(R"({"a":1,"…":"…"})", R"({"b":2})"), "");
  EXPECT_NE(mismatch(R"(["…","…"])", "[1,2,3]"), "");
  EXPECT_NE(mismatch("1", "2"), "");
  EXPECT_NE(mismatch("null", "0"), "");
  EXPECT_NE(mismatch(R"("x")", R"("y")"), "");
  EXPECT_NE(mismatch("true", "false"), "");
  EXPECT_NE(mismatch("{}", "{"), "");
}

TEST(ExampleMatching, OnlyMarkedBlocksAreRead) {
  const auto examples = read_examples(
      "→ no\n```\n→ no\n```\ntext\n```hedgehog\n→ {\"a\":1}\ncomment\n← {}\n```\n→ no\n");
  ASSERT_EQ(examples.size(), 1u);
  ASSERT_EQ(examples[0].lines.size(), 2u);
  EXPECT_TRUE(examples[0].lines[0].sent);
  EXPECT_EQ(examples[0].lines[0].text, "{\"a\":1}");
  EXPECT_FALSE(examples[0].lines[1].sent);
  EXPECT_EQ(examples[0].lines[1].number, 9);
}

}  // namespace
}  // namespace hedgehog::protocol
