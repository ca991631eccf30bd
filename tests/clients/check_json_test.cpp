// SPDX-License-Identifier: MIT
#include "clients/ctl/screen/check_json.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace hedgehog::client {
namespace {

using nlohmann::json;

TEST(CheckJson, HasTheFieldsOfTheLine) {
  const json object = json::parse(check_json(
      {1,
       "HEDGEHOG WARNING - ball armed, derated, 61.2 C, 9.0 A allowed | temperature=61.2;60;70 "
       "limit=9.0 lateness=412us;500 clients=2"}));
  EXPECT_EQ(object["code"], 1);
  EXPECT_EQ(object["state"], "WARNING");
  EXPECT_EQ(object["message"], "ball armed, derated, 61.2 C, 9.0 A allowed");
  const json measures{
      {"temperature", {{"value", 61.2}, {"unit", ""}, {"warning", 60}, {"critical", 70}}},
      {"limit", {{"value", 9.0}, {"unit", ""}}},
      {"lateness", {{"value", 412}, {"unit", "us"}, {"warning", 500}}},
      {"clients", {{"value", 2}, {"unit", ""}}}};
  EXPECT_EQ(object["measures"], measures);
}

TEST(CheckJson, AcceptsALineWithoutMeasures) {
  const json object = json::parse(check_json({2, "HEDGEHOG CRITICAL - no daemon answers - at a"}));
  EXPECT_EQ(object["state"], "CRITICAL");
  EXPECT_EQ(object["message"], "no daemon answers - at a");
  EXPECT_TRUE(object["measures"].empty());
}

}  // namespace
}  // namespace hedgehog::client
