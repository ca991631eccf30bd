// SPDX-License-Identifier: MIT
// The response timeout of a client, and how it can be set.
#include "clients/lib/response_timeout.h"

#include <gtest/gtest.h>

#include <optional>
#include <string>

namespace hedgehog::client {
namespace {

using namespace std::chrono_literals;

std::chrono::milliseconds with(const std::optional<std::string>& value) {
  return response_timeout([&](const std::string& name) {
    EXPECT_EQ(name, "HEDGEHOG_PATIENCE_MS");
    return value;
  });
}

TEST(ResponseTimeout, IsTwoSecondsUnlessSetInTheEnvironment) {
  EXPECT_EQ(with(std::nullopt), 2s);
  EXPECT_EQ(with("60000"), 60s);
  EXPECT_EQ(with("100"), 100ms);
  EXPECT_EQ(with("600000"), 600s);
}

TEST(ResponseTimeout, IgnoresValuesThatAreNoIntegerOfItsRange) {
  for (const char* nonsense : {"", "99", "600001", "-500", "+500", "5e3", "500ms", " 500", "500.0",
                               "99999999999999999999"})
    EXPECT_EQ(with(nonsense), 2s) << nonsense;
}

}  // namespace
}  // namespace hedgehog::client
