// SPDX-License-Identifier: MIT
// protocol/schema/ agrees with the code. To renew the files after a change of the protocol:
//   HEDGEHOG_WRITE_SCHEMA=1 build/dev/tests/test_protocol --gtest_filter='Schema.*'
#include "tests/protocol/schema.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <set>
#include <sstream>

#include "tests/folders.h"
#include "tests/protocol/random_request.h"

namespace hedgehog::protocol {
namespace {

std::string path_of(const std::string& file) {
  return source_folder() + "/protocol/schema/" + file;
}

std::string contents(const std::string& file) {
  std::ifstream in(path_of(file));
  std::stringstream text;
  text << in.rdbuf();
  return text.str();
}

void expect_current(const std::string& file, const Json& made) {
  if (std::getenv("HEDGEHOG_WRITE_SCHEMA") != nullptr) std::ofstream(path_of(file)) << pretty(made);
  EXPECT_TRUE(contents(file) == pretty(made)) << file << " is not what the code says; see the top "
                                              << "of this test for how to renew it";
}

TEST(Schema, FilesAreCurrent) {
  expect_current("openrpc.json", openrpc_document());
  expect_current("messages.schema.json", messages_schema());
}

TEST(Schema, OpenRpcHasExactlyTheMethodsOfTheTable) {
  const Json document = *parse_json(contents("openrpc.json"), 64);
  std::set<std::string> documented;
  for (const Json& method : *document.find("methods")->as<Json::List>())
    documented.insert(*method.find("name")->as<std::string>());
  std::set<std::string> served;
  for (const MethodInfo& row : kMethods) served.emplace(row.name);
  EXPECT_EQ(documented, served);
}

TEST(Schema, EachMethodHasItsErrors) {
  const auto has = [](std::string_view method, ErrorCode code) {
    return possible_errors(info(*method_named(method))).contains(code);
  };
  EXPECT_TRUE(has("effect.play", ErrorCode::kNoSuchPattern));
  EXPECT_FALSE(has("effect.pulse", ErrorCode::kNoSuchPattern));
  EXPECT_TRUE(has("ping", ErrorCode::kInvalidParams)) << "an unknown parameter";
  EXPECT_FALSE(has("ping", ErrorCode::kForbidden)) << "anybody may";
  const Json document = *parse_json(contents("openrpc.json"), 64);
  const Json& components = *document.find("components")->find("errors");
  for (const Json& method : *document.find("methods")->as<Json::List>()) {
    const auto& errors = *method.find("errors")->as<Json::List>();
    EXPECT_FALSE(errors.empty());
    for (const Json& error : errors) {
      const std::string ref = *error.find("$ref")->as<std::string>();
      EXPECT_NE(components.find(ref.substr(ref.rfind('/') + 1)), nullptr) << ref;
    }
  }
}

TEST(Schema, ParametersAreThoseOfTheDecoder) {
  const std::vector<std::string> pulse = parameter_names(*method_named("effect.pulse"));
  for (const std::string name :
       {"direction",   "level",        "current_a",   "force_n",     "gain",         "frame",
        "start_at_ns", "delay_ms",     "attack_ms",   "fade_ms",     "attack_level", "fade_level",
        "waveform",    "frequency_hz", "on_fraction", "duration_ms", "lease_ms",     "on_close",
        "slot",        "priority",     "if_limited"})
    EXPECT_NE(std::find(pulse.begin(), pulse.end(), name), pulse.end()) << name;
  EXPECT_EQ(pulse.size(), 21u);
  EXPECT_EQ(parameter_names(*method_named("effect.circle")).size(), 20u + 5u);
  EXPECT_EQ(parameter_names(kMethodOf<Ping>).size(), 0u);
}

TEST(Schema, NoTwoDefinitionsHaveOneName) {
  const Json messages = messages_schema();
  std::set<std::string> names;
  for (const auto& [name, schema] : *messages.find("$defs")->as<Json::Object>())
    EXPECT_TRUE(names.insert(name).second) << name;
  EXPECT_GT(names.size(), 20u);
}

TEST(Schema, AcceptsValidAndRejectsInvalid) {
  const Json messages = messages_schema();
  const auto broken = [&](const std::string& name, std::string_view text) {
    return violation(messages, name, *parse_json(text, 64));
  };
  EXPECT_EQ(broken("Request", R"({"jsonrpc":"2.0","method":"ping"})"), "");
  EXPECT_EQ(broken("Request",
                   R"({"jsonrpc":"2.0","method":"effect.pulse","params":{"direction":[0,0,1]}})"),
            "");
  EXPECT_NE(broken("Request", R"({"jsonrpc":"2.0","method":"effect.pulse","params":{}})"), "");
  EXPECT_NE(
      broken("Request", R"({"jsonrpc":"2.0","method":"effect.vibrate","params":{"level":1.5}})"),
      "");
  EXPECT_NE(broken("Request", R"({"jsonrpc":"2.0","method":"ping","params":{"x":1}})"), "");
  EXPECT_NE(broken("Ping", R"({"time_ns":"now"})"), "");
  EXPECT_NE(broken("Ping", "{}"), "");
  EXPECT_EQ(broken("Ping", R"({"time_ns":"…"})"), "");
}

}  // namespace
}  // namespace hedgehog::protocol
