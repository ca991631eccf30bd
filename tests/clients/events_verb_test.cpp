// SPDX-License-Identifier: MIT
// `hedgehogctl events --since ... -f` against a daemon that sends an event twice.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "clients/ctl/verbs/follow_verbs.h"
#include "protocol/server_codec.h"
#include "tests/clients/fake_daemon.h"

namespace hedgehog::client {
namespace {

protocol::Event derating_ended(std::int64_t time_ns) {
  protocol::Event event{.type = "derating_ended", .time_ns = time_ns};
  event.limit_a = 15.0;
  return event;
}

TEST(EventsVerb, EventsOfTheHistoryAreNotRepeated) {
  FakeDaemon daemon([](FakePeer& peer) {
    peer.read();
    peer.send_line(protocol::encode_result(protocol::Id::number(1), protocol::HelloResult{}));
    peer.read();
    peer.send_line(protocol::encode_result(
        protocol::Id::number(2), protocol::EventsResult{.state = "armed", .limit_a = 15.0}));
    peer.read();
    // Arrives between the subscription and the history request.
    peer.send_line(protocol::encode_event(derating_ended(7)));
    const protocol::PastEvent past{.at = "2026-11-20T23:14:07.412Z", .event = derating_ended(7)};
    peer.send_line(protocol::encode_encoded(
        protocol::Id::number(3),
        protocol::encode_history({protocol::encode_past_event(past)}, true)));
    peer.send_line(protocol::encode_event(derating_ended(8)));
  });
  Session session{Connection::open({daemon.address()}, kLongTimeout).value(), true, {}};
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  EXPECT_EQ(run_events(session, {{}, "1h", true}), kUnavailable);
  const std::string out = testing::internal::GetCapturedStdout();
  EXPECT_THAT(testing::internal::GetCapturedStderr(), testing::HasSubstr("only the newest 1"));
  EXPECT_EQ(std::count(out.begin(), out.end(), '\n'), 2) << out;
  EXPECT_THAT(out, testing::ContainsRegex("\"time_ns\":7.*\n.*\"time_ns\":8"));
}

protocol::Event overrun(std::int64_t second) {
  protocol::Event event{.type = "overrun", .time_ns = second * 1'000'000'000};
  event.skipped = 30;
  return event;
}

/// Output of `hedgehogctl events` for one overrun per second, with an emergency stop among them.
std::string printed_of_a_busy_machine(bool json) {
  FakeDaemon daemon([](FakePeer& peer) {
    peer.read();
    peer.send_line(protocol::encode_result(protocol::Id::number(1), protocol::HelloResult{}));
    peer.read();
    peer.send_line(protocol::encode_result(
        protocol::Id::number(2), protocol::EventsResult{.state = "armed", .limit_a = 15.0}));
    for (std::int64_t second = 1; second <= 20; ++second)
      peer.send_line(protocol::encode_event(overrun(second)));
    protocol::Event stopped{.type = "state_changed", .time_ns = 20'500'000'000};
    stopped.state = "disarmed";
    stopped.reason = "emergency_stop";
    peer.send_line(protocol::encode_event(stopped));
    for (std::int64_t second = 21; second <= 40; ++second)
      peer.send_line(protocol::encode_event(overrun(second)));
  });
  Session session{Connection::open({daemon.address()}, kLongTimeout).value(), json, {}};
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  EXPECT_EQ(run_events(session, {}), kUnavailable);
  testing::internal::GetCapturedStderr();
  return testing::internal::GetCapturedStdout();
}

TEST(EventsVerb, ASeriesIsItsFirstEventAndThenTheCount) {
  const std::string out = printed_of_a_busy_machine(false);
  const std::size_t first = out.find("overrun  30 ticks skipped\n");
  const std::size_t stopped = out.find("state_changed  disarmed: emergency_stop\n");
  const std::size_t all = out.find("overrun  1200 ticks skipped, 40 times since ");
  EXPECT_LT(first, stopped) << out;
  EXPECT_LT(stopped, all) << out;
  EXPECT_NE(all, std::string::npos) << out;
  EXPECT_LE(std::count(out.begin(), out.end(), '\n'), 5) << out;
}

TEST(EventsVerb, WithJsonEveryEventIsALine) {
  const std::string out = printed_of_a_busy_machine(true);
  EXPECT_EQ(std::count(out.begin(), out.end(), '\n'), 41) << out;
}

}  // namespace
}  // namespace hedgehog::client
