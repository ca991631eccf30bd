// SPDX-License-Identifier: MIT
// Recurring events are kept as one series, and displace no important event.
#include "daemon/server/history/event_series.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>

#include "base/wall_time.h"
#include "daemon/server/history/event_history.h"
#include "protocol/client_codec.h"
#include "tests/server/server_rig.h"

namespace hedgehog::server {
namespace {

constexpr std::int64_t kMinuteMs = 60'000;
constexpr std::int64_t kStartMs = 1'795'216'447'000;

protocol::Event overrun(std::uint64_t skipped) {
  protocol::Event event{.type = "overrun", .time_ns = 1};
  event.skipped = skipped;
  return event;
}

protocol::Event state_changed(const std::string& state, const std::string& reason) {
  protocol::Event event{.type = "state_changed", .time_ns = 1};
  event.state = state;
  event.reason = reason;
  return event;
}

class Series : public testing::Test {
 protected:
  EventHistory::Writer writer() {
    return [this](HistoryPart part, const std::string& lines, bool begin_file) {
      HistoryText& text = texts_[static_cast<std::size_t>(part)];
      if (begin_file) text.full = std::exchange(text.filling, {});
      text.filling += lines;
      return done_work();
    };
  }
  static std::vector<protocol::PastEvent> newest(const EventHistory& history,
                                                 const std::string& since = {}) {
    protocol::EventsHistory request;
    request.limit = 1000;
    if (!since.empty()) request.since = since;
    return protocol::decode_result<protocol::HistoryResult>(history.newest(request))->events;
  }
  std::string& file() { return texts_[static_cast<std::size_t>(HistoryPart::kRecurring)].filling; }
  long lines() { return std::count(file().begin(), file().end(), '\n'); }
  void record(EventHistory& history, std::int64_t unix_ms, std::uint64_t skipped = 2) {
    history.record(overrun(skipped), unix_ms, nullptr);
    history.pump(unix_ms);
    history.pump(unix_ms + 1);
  }

  HistoryTexts texts_;
};

TEST_F(Series, HasTheFirstTheCountTheLastAndTheSum) {
  EventHistory history(writer(), {});
  for (int i = 0; i < 37; ++i) record(history, kStartMs + 1000 * i);
  const auto events = newest(history);
  ASSERT_EQ(events.size(), 1u);
  EXPECT_EQ(events[0].at, base::rfc3339(kStartMs));
  EXPECT_EQ(events[0].count, 37);
  EXPECT_EQ(events[0].last, base::rfc3339(kStartMs + 36'000));
  EXPECT_EQ(events[0].event.skipped, 74u);
}

TEST_F(Series, ASingleEventIsNoSeries) {
  EventHistory history(writer(), {});
  record(history, kStartMs);
  EXPECT_EQ(newest(history)[0].count, std::nullopt);
  EXPECT_EQ(newest(history)[0].last, std::nullopt);
}

TEST_F(Series, OfAMeasurementIsThatOfOneWinding) {
  EventHistory history(writer(), {});
  for (const int coil : {0, 1, 0, 1, 1}) {
    protocol::Event event{.type = "measurement_rejected", .time_ns = 1};
    event.disagreement = protocol::Disagreement{coil, {"heat_balance", "resistance"}};
    history.record(event, kStartMs, nullptr);
  }
  const auto events = newest(history);
  ASSERT_EQ(events.size(), 2u);
  EXPECT_EQ(events[0].event.disagreement->coil, 0);
  EXPECT_EQ(events[0].count, 2);
  EXPECT_EQ(events[1].event.disagreement->coil, 1);
  EXPECT_EQ(events[1].count, 3);
}

TEST_F(Series, EndsAfterAQuietMinuteAndAfterAnHour) {
  EventHistory history(writer(), {});
  record(history, kStartMs);
  record(history, kStartMs + kMinuteMs);
  record(history, kStartMs + 2 * kMinuteMs + 1);
  EXPECT_EQ(newest(history).size(), 2u);
  for (int i = 0; i < 180; ++i) record(history, kStartMs + (3 + i) * kMinuteMs);
  EXPECT_EQ(newest(history).size(), 4u) << "three hours";
  record(history, kStartMs);
  EXPECT_EQ(newest(history).size(), 5u) << "a clock that was set back";
}

TEST_F(Series, IsFoundByTheTimeOfItsLastEvent) {
  EventHistory history(writer(), {});
  for (int i = 0; i < 10; ++i) record(history, kStartMs + 30'000 * i);
  EXPECT_EQ(newest(history, base::rfc3339(kStartMs + 200'000)).size(), 1u);
  EXPECT_TRUE(newest(history, base::rfc3339(kStartMs + 300'000)).empty());
}

TEST_F(Series, IsOnDiskAtItsBeginningEveryTenMinutesAndAtItsEnd) {
  EventHistory history(writer(), {});
  record(history, kStartMs);
  EXPECT_EQ(lines(), 1);
  for (int i = 1; i < 600; ++i) record(history, kStartMs + 1000 * i);
  EXPECT_EQ(lines(), 1);
  record(history, kStartMs + 600'000);
  EXPECT_EQ(lines(), 2);
  EXPECT_EQ(newest(EventHistory(writer(), texts_)), newest(history));
  record(history, kStartMs + 601'000);
  history.pump(kStartMs + 700'000);
  history.pump(kStartMs + 702'000);
  EXPECT_EQ(lines(), 3) << "it is over";
  EXPECT_EQ(newest(EventHistory(writer(), texts_)), newest(history));
}

TEST_F(Series, IsOnDiskWhenTheDaemonStops) {
  EventHistory history(writer(), {});
  for (int i = 0; i < 5; ++i) record(history, kStartMs + 2000 * i);
  history.record({.type = "shutting_down", .time_ns = 1}, kStartMs + 9000, nullptr);
  for (int i = 0; i < 4; ++i) history.flush();
  const auto events = newest(EventHistory(writer(), texts_));
  ASSERT_EQ(events.size(), 2u);
  EXPECT_EQ(events[0].count, 5);
}

TEST_F(Series, IsWrittenCompletelyAfterADiskError) {
  bool fails = true;
  EventHistory history(
      [&](HistoryPart part, const std::string& lines, bool begin_file) {
        return fails ? done_work("no space left") : writer()(part, lines, begin_file);
      },
      {});
  for (int i = 0; i < 5000; ++i) record(history, kStartMs + 2000 * i);
  EXPECT_EQ(file(), "");
  fails = false;
  history.pump(kStartMs + 10'000'000);
  for (int i = 0; i < 4; ++i) history.flush();
  EXPECT_EQ(newest(EventHistory(writer(), texts_)), newest(history));
}

TEST_F(Series, DisplacesNeitherDeratingNorAnEmergencyStop) {
  EventHistory history(writer(), {});
  history.record(state_changed("disarmed", "emergency_stop"), kStartMs, nullptr);
  history.record({.type = "derating_started", .time_ns = 1}, kStartMs, nullptr);
  // Each starts a new series.
  for (int i = 1; i <= 6000; ++i) record(history, kStartMs + 2 * kMinuteMs * i);
  const HistoryTexts kept = texts_;
  for (const bool restarted : {false, true}) {
    const EventHistory again(writer(), kept);
    protocol::EventsHistory request;
    request.types = {"state_changed", "derating_started"};
    const auto found = protocol::decode_result<protocol::HistoryResult>(
        (restarted ? again : history).newest(request));
    ASSERT_EQ(found->events.size(), 2u) << restarted;
    EXPECT_EQ(found->events[0].event.reason, "emergency_stop");
  }
}

TEST_F(Series, ADayOfDeratingDisplacesNoEmergencyStop) {
  EventHistory history(writer(), {});
  history.record(state_changed("disarmed", "emergency_stop"), kStartMs, nullptr);
  for (int i = 1; i <= 6000; ++i) {
    const std::string type = i % 2 == 0 ? "derating_ended" : "derating_started";
    history.record({.type = type, .time_ns = i}, kStartMs + 1000 * i, nullptr);
    history.pump(kStartMs + 1000 * i);
    history.pump(kStartMs + 1000 * i + 1);
  }
  const HistoryTexts kept = texts_;
  for (const bool restarted : {false, true}) {
    const EventHistory again(writer(), kept);
    const EventHistory& found = restarted ? again : history;
    protocol::EventsHistory request;
    request.types = {"state_changed"};
    const auto stops = protocol::decode_result<protocol::HistoryResult>(found.newest(request));
    ASSERT_EQ(stops->events.size(), 1u) << restarted;
    EXPECT_EQ(stops->events[0].event.reason, "emergency_stop");
    EXPECT_EQ(newest(found).back().event.type, "derating_ended") << "in their order of time";
  }
}

TEST_F(Series, SingleEventsOfAnEarlierVersionAreMergedToo) {
  HistoryTexts old;
  std::string& text = old[static_cast<std::size_t>(HistoryPart::kBall)].filling;
  for (int i = 0; i < 812; ++i) {
    text += R"({"at":")" + base::rfc3339(kStartMs + 1000 * i) +
            R"(","type":"overrun","time_ns":1,"skipped":3})" + "\n";
    if (i == 400) {
      text += R"({"at":")" + base::rfc3339(kStartMs + 1000 * i) +
              R"(","type":"derating_started","time_ns":1,"limit_a":9,"temperature_c":61})" + "\n";
    }
  }
  const auto events = newest(EventHistory(writer(), old));
  ASSERT_EQ(events.size(), 2u);
  EXPECT_EQ(events[0].count, 812);
  EXPECT_EQ(events[0].event.skipped, 2436u);
  EXPECT_EQ(events[1].event.type, "derating_started");
}

}  // namespace
}  // namespace hedgehog::server
