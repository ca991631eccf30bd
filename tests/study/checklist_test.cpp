// SPDX-License-Identifier: MIT
// The checklist before a run: invalid answers are rejected, and only those questions are repeated.
#include "clients/study/verbs/checklist.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "clients/study/verbs/checklist_answers.h"

namespace hedgehog::study {
namespace {

using testing::HasSubstr;

/// Gives the answers one after the other, and records the questions.
struct ScriptedPrompt {
  std::vector<std::string> answers;
  std::vector<std::string> questions{};
  Prompt ask() {
    return [this](const std::string& question) -> std::optional<std::string> {
      questions.push_back(question);
      if (questions.size() > answers.size()) return std::nullopt;
      return answers[questions.size() - 1];
    };
  }
};

Checklist all_but_ready() {
  Checklist list;
  list.experimenter = "E1";
  list.consent = "014";
  list.age_band = "22-29";
  list.dominant_hand = "right";
  list.hand_size_cm = 18.3;
  return list;
}

TEST(HandSize, IsANumberInCentimetresAndNothingElse) {
  EXPECT_EQ(parse_hand_size("18.3").value(), 18.3);
  EXPECT_EQ(parse_hand_size(" 10 ").value(), 10.0);
  EXPECT_EQ(parse_hand_size("30\r").value(), 30.0);
  for (const char* wrong : {"", "18.3 foo", "18.3cm", "183", "9.9", "30.1", "nan", "inf", "0x12",
                            "1.8e1", "-18", "+18", "18.3.1", "18 3"})
    EXPECT_FALSE(parse_hand_size(wrong)) << wrong;
  EXPECT_THAT(parse_hand_size("18,3").error().message, HasSubstr("write 18,3 with a point, 18.3"));
  EXPECT_THAT(parse_hand_size("18.3 foo").error().message, HasSubstr("not \"18.3 foo\""));
}

TEST(AgeBand, IsTwoAgesOrOneAndAbove) {
  for (const char* right : {"22-29", "0-9", "70+", "18-120"})
    EXPECT_EQ(parse_age_band(right).value(), right);
  EXPECT_EQ(parse_age_band(" 22-29 ").value(), "22-29");
  EXPECT_EQ(parse_age_band("").value(), "");
  for (const char* wrong : {"24", "old", "29-22", "22-22", "22-", "-29", "22--29", "22-29 x", "+",
                            "121+", "120+", "22-290", "22-29-35", "22.5-29"})
    EXPECT_FALSE(parse_age_band(wrong)) << wrong;
}

TEST(Checklist, RepeatsInvalidItemsAndKeepsTheRest) {
  ScriptedPrompt desk{{"E1", "014", "young", "22-29", "both", "left", "18,3", "18.3 foo", "18.3",
                       "u", "", "y", "n", "YES"}};
  const auto list = complete({}, desk.ask());
  ASSERT_TRUE(list);
  EXPECT_EQ(list->experimenter, "E1");
  EXPECT_EQ(list->consent, "014");
  EXPECT_EQ(list->age_band, "22-29");
  EXPECT_EQ(list->dominant_hand, "left");
  EXPECT_EQ(list->hand_size_cm, 18.3);
  EXPECT_TRUE(list->headphones && list->hand_on_top);
  EXPECT_EQ(desk.questions.size(), desk.answers.size());
  EXPECT_THAT(desk.questions[3], HasSubstr("not \"young\""));
  EXPECT_THAT(desk.questions[7], HasSubstr("with a point"));
  EXPECT_THAT(desk.questions[10], HasSubstr("y or n, please: noise-cancelling"));
  EXPECT_THAT(desk.questions[13], HasSubstr("q gives up: dominant hand on top"));
}

TEST(Checklist, EndsWhenTheExperimenterQuitsOrTheInputEnds) {
  ScriptedPrompt quits{{"n", "q"}};
  EXPECT_FALSE(complete(all_but_ready(), quits.ask()));
  ScriptedPrompt ends{{"y"}};
  EXPECT_FALSE(complete(all_but_ready(), ends.ask()));
  ScriptedPrompt none{{}};
  EXPECT_FALSE(complete({}, none.ask()));
}

TEST(Checklist, IsConfirmedAgainWithoutTheOtherItems) {
  ScriptedPrompt desk{{"y", "maybe", "y"}};
  EXPECT_EQ(ticked_again(all_but_ready(), desk.ask())->consent, "014");
  ScriptedPrompt sure{{"what", "n"}};
  EXPECT_EQ(confirm("the same ball?", sure.ask()), false);
  EXPECT_THAT(sure.questions[1], HasSubstr("the same ball?"));
}

}  // namespace
}  // namespace hedgehog::study
