// SPDX-License-Identifier: MIT
// Texts for participant and experimenter, intervals that make a trial void, and experiments beyond
// a ball's limits.
#include "clients/study/session/screen.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "clients/study/journal/codec.h"
#include "clients/study/session/player.h"
#include "clients/study/verbs/session_start.h"
#include "tests/study/recorded.h"

namespace hedgehog::study {
namespace {

using testing::HasSubstr;

TEST(Fault, IsAnyIncompleteDelivery) {
  const Pattern pattern;
  EXPECT_FALSE(fault_of(good(1, 5), pattern));
  const auto fault = [&](auto change) {
    IntervalPlayed played = good(2, 5);
    change(played);
    return fault_of(played, pattern).value_or("none");
  };
  EXPECT_EQ(fault([](auto& p) { p.delivered_min = 0.979; }), "interval 2 was delivered at 97 %");
  EXPECT_EQ(fault([](auto& p) { p.delivered_min = 0.98; }), "none");
  EXPECT_EQ(fault([](auto& p) { p.masked_ms = 1; }), "interval 2 was masked by another effect");
  EXPECT_EQ(fault([](auto& p) { p.mixed_ms = 1; }), "interval 2 was mixed with another effect");
  EXPECT_EQ(fault([](auto& p) { p.reason = "tripped"; }), "interval 2 ended as tripped");
  EXPECT_EQ(fault([](auto& p) { p.onset_ns.reset(); }), "interval 2 never began");
  const std::string undelivered = "interval 2 ended without a delivery report";
  EXPECT_EQ(fault([](auto& p) { p.delivered_min.reset(); }), undelivered);
  EXPECT_EQ(fault([](auto& p) { p.masked_ms.reset(); }), undelivered);
  EXPECT_EQ(fault([](auto& p) { p.mixed_ms.reset(); }), undelivered);
  EXPECT_EQ(fault([](auto& p) { *p.offset_ns -= 10'000'000; }), "interval 2 was cut short");
}

TEST(Participant, IsNeverShownLevelCorrectnessOrProgress) {
  const RecordedRun run = recorded();
  for (int phase = 0; phase <= static_cast<int>(Phase::kOver); ++phase) {
    View view{&run, static_cast<Phase>(phase), 1, "level 3.45, wrong, trial 7 of 40", 41.0};
    const Cue cue = cue_of(view);
    EXPECT_EQ(decode_cue(encode(cue)), cue);
    std::string all;
    for (const std::string& line : participant_lines(cue)) {
      EXPECT_LE(line.size(), 80U);
      all += line + "\n";
    }
    EXPECT_EQ(all.find_first_of("0123456789"), std::string::npos) << all;
    for (const char* secret : {"wrong", "right", "level", "reversal", "trial", "correct"})
      EXPECT_THAT(all, testing::Not(HasSubstr(secret)));
  }
}

TEST(Experimenter, SeesTheStaircase) {
  const RecordedRun run = recorded();
  std::string all;
  for (const std::string& line :
       experimenter_lines({&run, Phase::kQuestion, 2, "30.0 °C, next trial at full strength", 30}))
    all += line + "\n";
  EXPECT_THAT(all, HasSubstr("P01 · force-jnd · scored trial 3 · waiting for the answer"));
  EXPECT_THAT(all, HasSubstr("level 109.024 %   reversals 1 of 10   voids 1"));
}

TEST(Blind, IsForTheWholeRun) {
  RunStarted header = recorded().header();
  EXPECT_FALSE(recorded().blind());
  RecordedRun late = recorded();
  ASSERT_TRUE(late.take({late.lines() + 1, "t", Remark{"blind", ""}}));
  EXPECT_TRUE(late.blind());
  header.blind = true;
  header.person_seed = 77;
  const Line line = decode(encode(Line{1, "t", header})).value();
  EXPECT_EQ(std::get<RunStarted>(line.event), header);
  EXPECT_TRUE(RecordedRun::replay({line}).value().blind());
}

TEST(ExitCode, FollowsTheDaemonsError) {
  using client::Failure;
  const auto refused = [](protocol::ErrorCode code) {
    return report_error(
        client::ClientError{Failure::kRefused, "no", protocol::RpcError{code, "no"}});
  };
  EXPECT_EQ(refused(protocol::ErrorCode::kForbidden), EX_NOPERM);
  EXPECT_EQ(refused(protocol::ErrorCode::kUnauthorized), EX_NOPERM);
  EXPECT_EQ(refused(protocol::ErrorCode::kClaimed), EX_TEMPFAIL);
  EXPECT_EQ(refused(protocol::ErrorCode::kDeviceAbsent), EX_UNAVAILABLE);
  EXPECT_EQ(report_error(client::ClientError{Failure::kBadAddress, "no", {}}), EX_USAGE);
}

TEST(Ball, IsRequiredToPlayTheWholeExperiment) {
  Experiment e = find_experiment("force-jnd").value();
  EXPECT_FALSE(beyond(e, 15.0));
  EXPECT_THAT(*beyond(e, 10.0), HasSubstr("goes up to 15 A and this ball plays at most 10 A"));
  EXPECT_THAT(*beyond(e, 10.0), HasSubstr("lower its ceiling"));
  EXPECT_THAT(*beyond(find_experiment("speed-jnd").value(), 4.0), HasSubstr("lower its c"));
  e = find_experiment("force-threshold").value();
  e.rule.ceiling = 30000;
  EXPECT_FALSE(beyond(e, 3.0));
}

}  // namespace
}  // namespace hedgehog::study
