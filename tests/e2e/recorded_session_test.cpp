// SPDX-License-Identifier: MIT
// A recorded session of protocol 1.0: the requests of a client of that version are still accepted,
// and the members that it reads are present.
#include <gtest/gtest.h>

#include <fstream>
#include <string>

#include "tests/e2e/daemon_process.h"
#include "tests/e2e/raw_client.h"
#include "tests/folders.h"

namespace hedgehog::e2e {
namespace {

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

/// Lines "→ request", "← response or notification", in the order of the recording.
TEST(RecordedSession, OfProtocol10IsUnderstoodToday) {
  const Home home;
  DaemonProcess daemon(home);
  RawClient client(daemon.port());
  std::ifstream file(source_folder() + "/tests/e2e/session_1_0.txt");
  const std::string sent = "→ ";
  std::string method;
  int lines = 0;
  for (std::string line; std::getline(file, line); ++lines) {
    const Json then = Json::parse(line.substr(sent.size()));
    if (line.starts_with(sent)) {
      method = then["method"];
      ASSERT_TRUE(client.send(line.substr(sent.size()) + "\n"));
    } else if (then.contains("method")) {
      const std::string type = then["params"].value("type", "");
      const Json now = client.notification(then["method"], type);
      expect_has(now, then["params"], then["method"].get<std::string>() + " " + type);
    } else {
      const Json now = client.answer();
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
  }
  EXPECT_GT(lines, 60) << "the recording";
}

}  // namespace
}  // namespace hedgehog::e2e
