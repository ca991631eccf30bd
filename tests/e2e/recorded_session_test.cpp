// SPDX-License-Identifier: MIT
// Recorded sessions of protocol 1.0, one of a plain socket and one of each client library: the
// requests of a client of that version are still accepted, and the members that it reads are
// present.
#include <gtest/gtest.h>

#include <fstream>
#include <set>
#include <string>
#include <vector>

#include "protocol/methods.h"
#include "tests/e2e/daemon_process.h"
#include "tests/e2e/raw_client.h"
#include "tests/folders.h"

namespace hedgehog::e2e {
namespace {

const std::string kSent = "→ ";
/// LIBRARY_VERSION.
const std::vector<std::string> kSessions{"cpp_1_0", "javascript_1_0", "python_1_0", "raw_1_0"};

/// Lines "→ request", "← response or notification", in the order of the recording.
std::vector<std::string> session_lines(const std::string& session) {
  std::ifstream file(source_folder() + "/tests/e2e/sessions/" + session + ".txt");
  std::vector<std::string> lines;
  for (std::string line; std::getline(file, line);) lines.push_back(line);
  return lines;
}

Json message_of(const std::string& line) { return Json::parse(line.substr(kSent.size())); }

std::string kind_of(const Json& value) {
  return value.is_number() ? "number" : std::string(value.type_name());
}

/// Fails where `now` lacks a member of `then` or an element of the same kind. Values may differ;
/// null may have become a value, and a value null.
void expect_has(const Json& now, const Json& then, const std::string& where) {
  if (now.is_null() || then.is_null()) return;
  ASSERT_EQ(kind_of(now), kind_of(then)) << where;
  for (const auto& [key, value] : then.items()) {
    if (then.is_object()) {
      ASSERT_TRUE(now.contains(key)) << where << "." << key << " is gone";
      expect_has(now[key], value, where + "." + key);
    } else if (then.is_array()) {
      // Of events, compares the first of the same type: which ones arrive depends on timing.
      const bool typed = value.is_object() && value.contains("type");
      for (const Json& element : now) {
        if (typed && element.value("type", "") != value["type"]) continue;
        expect_has(element, value, where + "[]");
        break;
      }
    }
  }
}

void expect_response(const Json& now, const Json& then, const std::string& method) {
  ASSERT_EQ(now["id"], then["id"]) << method;
  ASSERT_EQ(now.contains("error"), then.contains("error")) << method << now;
  if (then.contains("error")) {
    EXPECT_EQ(now["error"]["code"], then["error"]["code"]) << method;
    EXPECT_EQ(now["error"]["data"]["name"], then["error"]["data"]["name"]) << method;
    expect_has(now["error"], then["error"], method);
  } else {
    expect_has(now["result"], then["result"], method);
  }
}

class RecordedSession : public testing::TestWithParam<std::string> {};

TEST_P(RecordedSession, IsAccepted) {
  const Home home;
  DaemonProcess daemon(home);
  RawClient client(daemon.port());
  const std::vector<std::string> lines = session_lines(GetParam());
  std::string method;
  for (const std::string& line : lines) {
    const Json then = message_of(line);
    if (line.starts_with(kSent)) {
      method = then["method"];
      ASSERT_TRUE(client.send(line.substr(kSent.size()) + "\n"));
    } else if (then.contains("method")) {
      const std::string type = then["params"].value("type", "");
      const Json now = client.notification(then["method"], type);
      expect_has(now, then["params"], then["method"].get<std::string>() + " " + type);
    } else {
      ASSERT_NO_FATAL_FAILURE(expect_response(client.response(), then, method));
    }
  }
  EXPECT_GT(lines.size(), 60U) << "the recording";
}

INSTANTIATE_TEST_SUITE_P(Of, RecordedSession, testing::ValuesIn(kSessions),
                         [](const auto& session) { return session.param; });

/// In the sessions of all versions.
std::set<std::string> methods_called(const std::string& library) {
  std::set<std::string> called;
  for (const std::string& session : kSessions) {
    if (!session.starts_with(library + "_")) continue;
    for (const std::string& line : session_lines(session))
      if (line.starts_with(kSent)) called.insert(message_of(line)["method"]);
  }
  return called;
}

/// A session with a new method is recorded by tests/sdk/sessions/record.py.
TEST(RecordedSessions, HaveEveryMethod) {
  for (const char* library : {"cpp", "javascript", "python"}) {
    const std::set<std::string> called = methods_called(library);
    for (const protocol::MethodInfo& method : protocol::kMethods)
      EXPECT_TRUE(called.contains(std::string(method.name))) << library << ": " << method.name;
  }
}

}  // namespace
}  // namespace hedgehog::e2e
