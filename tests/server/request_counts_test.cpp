// SPDX-License-Identifier: MIT
// Requests by method and error, as the metrics show them.
#include "daemon/server/session/request_counts.h"

#include <gtest/gtest.h>

#include <map>
#include <string>
#include <utility>

namespace hedgehog::server {
namespace {

using protocol::ErrorCode;

using All = std::map<std::pair<std::string, int>, std::uint64_t>;
All all_of(const RequestCounts& counts) {
  All all;
  counts.for_each([&](const RequestCounts::Series& of) {
    EXPECT_TRUE(all.emplace(std::pair(std::string(of.method), of.code), of.count).second)
        << of.method << " " << of.code << " is reported twice";
  });
  return all;
}

TEST(RequestCounts, HaveEveryErrorThatAMethodMayReturn) {
  const All all = all_of({});
  for (const protocol::MethodInfo& method : protocol::kMethods) {
    const std::string name(method.name);
    EXPECT_TRUE(all.contains({name, 0})) << name;
    for (const ErrorCode code : protocol::kErrorCodes)
      EXPECT_EQ(all.contains({name, static_cast<int>(code)}),
                protocol::possible_errors(method).contains(code))
          << name << " " << static_cast<int>(code);
  }
  for (const auto& [series, count] : all) EXPECT_EQ(count, 0U) << series.first;
}

TEST(RequestCounts, OfNoMethodHaveTheErrorsOfDecoding) {
  const All all = all_of({});
  for (const int code : {-32700, -32600, -32601, -32602})
    EXPECT_TRUE(all.contains({"none", code})) << code;
  EXPECT_FALSE(all.contains({"none", 0}));
}

TEST(RequestCounts, CountEachSeriesByItself) {
  RequestCounts counts;
  const auto ping = protocol::method_named("ping");
  counts.add(ping, std::nullopt);
  counts.add(ping, std::nullopt);
  counts.add(ping, ErrorCode::kBusy);
  counts.add(std::nullopt, ErrorCode::kParseError);
  All expected = all_of({});
  expected[{"ping", 0}] = 2;
  expected[{"ping", -32001}] = 1;
  expected[{"none", -32700}] = 1;
  EXPECT_EQ(all_of(counts), expected);
}

TEST(RequestCounts, ShowAnErrorThatTheMethodIsNotExpectedToReturn) {
  RequestCounts counts;
  counts.add(protocol::method_named("ping"), ErrorCode::kNotArmed);
  EXPECT_EQ(all_of(counts).at({"ping", -32000}), 1U);
}

/// Each is a series that Prometheus stores for each ball.
TEST(RequestCounts, AreFewerThanFourHundred) { EXPECT_LT(all_of({}).size(), 400U); }

}  // namespace
}  // namespace hedgehog::server
