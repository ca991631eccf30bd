// SPDX-License-Identifier: MIT
// Evidence that a daemon has the ball on which a run was begun.
#include "clients/study/journal/identity.h"

#include <gtest/gtest.h>

#include "clients/study/journal/codec.h"
#include "clients/study/journal/recorded_run.h"
#include "clients/study/verbs/session_start.h"
#include "tests/study/recorded.h"

namespace hedgehog::study {
namespace {

const Pin kReal{{"ball", "hedgehog-86", "A1", false}, {"/run/hedgehogd.sock", "01"}};
const Pin kSimulated{{"ball", "hedgehog-86", std::nullopt, true}, {"/run/hedgehogd.sock", "01"}};

Pin with(Pin pin, const DaemonFacts& daemon) {
  pin.daemon = daemon;
  return pin;
}

TEST(Identity, IsTheStartOfTheDaemon) {
  for (const Pin& pin : {kReal, kSimulated}) {
    EXPECT_EQ(compare(pin, pin), Identity::kSame);
    EXPECT_EQ(compare(pin, with(pin, {"127.0.0.1:7586", "01"})), Identity::kSame);
    EXPECT_EQ(compare(pin, with(pin, {"/run/hedgehogd.sock", "02"})), Identity::kUnproven);
  }
  Pin recalibrated = kReal;
  recalibrated.ball.force_n_per_a = 0.013;
  EXPECT_EQ(compare(kReal, recalibrated), Identity::kSame);
}

TEST(Identity, IsAnotherForAnotherBall) {
  Pin other = kReal;
  other.ball.serial = "A2";
  EXPECT_EQ(compare(kReal, other), Identity::kOther);
  other.ball.serial.reset();
  EXPECT_EQ(compare(kReal, other), Identity::kOther);
  EXPECT_EQ(compare(kReal, kSimulated), Identity::kOther);
}

TEST(Identity, IsTheSerialNumberIfADaemonReportsNoStart) {
  const DaemonFacts old{"/run/hedgehogd.sock", ""};
  EXPECT_EQ(compare(with(kReal, old), with(kReal, old)), Identity::kSame);
  EXPECT_EQ(compare(kReal, with(kReal, old)), Identity::kSame);
  EXPECT_EQ(compare(kReal, with(kReal, {"127.0.0.1:7586", ""})), Identity::kUnproven);
  // An older journal has no address.
  EXPECT_EQ(compare(with(kReal, {}), kReal), Identity::kSame);
  // Simulators have no serial number, so that they cannot be distinguished.
  EXPECT_EQ(compare(with(kSimulated, old), with(kSimulated, old)), Identity::kUnproven);
  EXPECT_EQ(compare(with(kSimulated, {}), kSimulated), Identity::kUnproven);
  EXPECT_FALSE(same_serial(kSimulated.ball, kSimulated.ball));
}

RecordedRun run_with(const Pin& pin, bool simulated_person) {
  RunStarted header = recorded().header();
  header.ball = pin.ball;
  header.daemon = pin.daemon;
  header.simulated_person = simulated_person;
  return RecordedRun::replay({decode(encode({1, "t", header})).value()}).value();
}

TEST(Resume, PromptsForWhatCannotBeVerified) {
  int prompts = 0;
  std::string answer = "y";
  const Prompt prompt = [&](const std::string&) {
    ++prompts;
    return std::optional(answer);
  };
  const Pin restarted = with(kSimulated, {"/run/hedgehogd.sock", "02"});
  EXPECT_TRUE(confirm_daemon(run_with(kSimulated, false), kSimulated, false, prompt));
  EXPECT_TRUE(confirm_daemon(run_with(kReal, false), with(kReal, {"x", "02"}), false, prompt));
  EXPECT_EQ(prompts, 0);
  EXPECT_TRUE(confirm_daemon(run_with(kSimulated, false), restarted, false, prompt));
  EXPECT_EQ(prompts, 1);
  answer = "n";
  EXPECT_EQ(confirm_daemon(run_with(kSimulated, false), restarted, false, prompt).error().exit_code,
            EX_CONFIG);
  // A rehearsal continues after a restart, at another address only if that is given.
  const Pin elsewhere = with(kSimulated, {"127.0.0.1:7586", "02"});
  EXPECT_TRUE(confirm_daemon(run_with(kSimulated, true), restarted, false, prompt));
  EXPECT_FALSE(confirm_daemon(run_with(kSimulated, true), elsewhere, false, prompt));
  EXPECT_TRUE(confirm_daemon(run_with(kSimulated, true), elsewhere, true, prompt));
  EXPECT_EQ(prompts, 2);
}

TEST(DaemonChanged, ReplacesTheDaemonOfTheRun) {
  RecordedRun run = run_with(kSimulated, false);
  EXPECT_EQ(run.pin().daemon.start_id, "01");
  const DaemonChanged changed{{"127.0.0.1:7586", "02"}};
  const Line line = decode(encode({2, "t", changed})).value();
  EXPECT_EQ(std::get<DaemonChanged>(line.event), changed);
  ASSERT_TRUE(run.take(line));
  EXPECT_EQ(run.pin().daemon, changed.daemon);
  EXPECT_EQ(run.header().daemon.start_id, "01");
}

TEST(DaemonChanged, IsAbsentFromOlderJournals) {
  const Line line = decode(encode({1, "t", recorded().header()})).value();
  EXPECT_EQ(std::get<RunStarted>(line.event).daemon, DaemonFacts{});
  std::string text = encode({1, "t", recorded().header()});
  const auto begin = text.find(",\"daemon\"");
  ASSERT_NE(begin, std::string::npos);
  text.erase(begin, text.find('}', begin) + 1 - begin);
  EXPECT_EQ(std::get<RunStarted>(decode(text).value().event).daemon, DaemonFacts{});
}

TEST(Journals, OfOlderVersionsHaveNoOrientationsAndAreReadUnchanged) {
  const Line line =
      decode(R"({"n":7,"time":"t","event":"interval","interval":2,"current_a":5,"speed_pins_s":10,)"
             R"("command_ns":100,"ack_ns":200,"onset_ns":300,"offset_ns":5000000300,)"
             R"("reason":"completed","delivered_min":1.0,"delivered_mean":1.0,"masked_ms":0,)"
             R"("mixed_ms":0,"measured_a":4.99,"temperature_c":30.5})")
          .value();
  const auto& played = std::get<IntervalPlayed>(line.event);
  EXPECT_EQ(played.temperature_c, 30.5);
  EXPECT_EQ(played.offset_ns, 5'000'000'300);
  EXPECT_FALSE(played.orientation);
}

}  // namespace
}  // namespace hedgehog::study
