// SPDX-License-Identifier: MIT
// events.history: which events are kept, how many, and across restarts.
#include <gtest/gtest.h>

#include <algorithm>

#include "base/wall_time.h"
#include "daemon/server/history/event_history.h"
#include "protocol/client_codec.h"
#include "protocol/server_codec.h"
#include "tests/server/server_rig.h"

namespace hedgehog::server {
namespace {

using Types = std::vector<std::string>;

protocol::HistoryResult newest(const EventHistory& history, std::int64_t limit,
                               const Types& types = {}) {
  protocol::EventsHistory request;
  request.limit = limit;
  request.types = types;
  return *protocol::decode_result<protocol::HistoryResult>(
      history.newest(request, [](unsigned) { return true; }));
}

std::size_t lines_in(const std::string& text) {
  return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

TEST(History, IsFilteredByTypesSinceAndLimit) {
  ServerRig rig;
  FakeClient& game = rig.connect();
  for (int i = 0; i < 10; ++i) {
    rig.call(game, "effect.pulse", {{"direction", "left"}, {"duration_ms", 5}});
    rig.run(15);
  }
  const auto history_of = [&](const Json& params) {
    return rig.call(game, "events.history", params);
  };
  const Json all = history_of({{"types", {"effect_ended"}}});
  ASSERT_EQ(all["events"].size(), 10u);
  EXPECT_EQ(all["more"], false);
  EXPECT_EQ(all["events"][9]["at"], base::rfc3339(rig.wall_ms() - 9)) << "5 ms and a tick";
  const Json three = history_of({{"types", {"effect_ended"}}, {"limit", 3}});
  ASSERT_EQ(three["events"].size(), 3u);
  EXPECT_EQ(three["more"], true);
  EXPECT_EQ(three["events"][2], all["events"][9]) << "the newest";
  EXPECT_EQ(history_of({{"types", {"effect_started"}}})["events"].size(), 10u);
  EXPECT_TRUE(history_of({{"since", "2999-01-01T00:00:00Z"}})["events"].empty());
  EXPECT_EQ(history_of({{"since", "2000-01-01T00:00:00+02:00"}, {"limit", 1000}}),
            history_of({{"limit", 1000}}));
  const Json since = history_of({{"since", all["events"][7]["at"]}, {"types", {"effect_ended"}}});
  EXPECT_EQ(since["events"].size(), 3u);
  EXPECT_EQ(history_of({{"since", "yesterday"}})["data"]["field"], "since");
  EXPECT_EQ(history_of({{"limit", 1001}})["data"]["limit"], 1000);
  EXPECT_EQ(history_of({{"types", {"overun"}}})["data"]["field"], "types");
}

TEST(History, UpdatesOfEveryFrameAreNotKept) {
  ServerRig rig;
  FakeClient& game = rig.connect();
  for (int i = 0; i < 60; ++i) {
    rig.call(game, "effect.vibrate", {{"slot", "engine"}, {"lease_ms", 250}});
    rig.run(16);
  }
  rig.run(300);
  const Json events =
      rig.call(game, "events.history", {{"types", {"effect_started", "effect_ended"}}})["events"];
  ASSERT_EQ(events.size(), 2u);
  EXPECT_EQ(events[1]["reason"], "expired");
}

/// Files in memory.
struct Disk {
  EventHistory::Writer writer() {
    return [this](HistoryPart part, const std::string& lines, bool begin_file) {
      HistoryText& text = texts[static_cast<std::size_t>(part)];
      if (begin_file) text.full = std::exchange(text.filling, {});
      text.filling += lines;
      return done_work();
    };
  }
  HistoryText& effects() { return texts[static_cast<std::size_t>(HistoryPart::kEffects)]; }
  HistoryText& trips() { return texts[static_cast<std::size_t>(HistoryPart::kTrips)]; }
  HistoryTexts texts;
};

/// Flushes to a disk that completes at once.
void flush(EventHistory& history) {
  bool all = false;
  for (std::size_t i = 0; i < 20 && !all; ++i) all = history.flush();
  EXPECT_TRUE(all);
}

protocol::Event ended(std::uint32_t effect) {
  protocol::Event event{.type = "effect_ended", .time_ns = effect};
  event.effect = effect;
  event.reason = "completed";
  return event;
}

protocol::Event tripped() {
  protocol::Event event{.type = "state_changed", .time_ns = 1};
  event.state = "tripped";
  event.reason = "sensor_frozen";
  event.current_a = 5.0;
  return event;
}

TEST(History, IsBoundedAndEffectsDoNotDisplaceTrips) {
  Disk disk;
  EventHistory history(disk.writer(), {});
  history.record(tripped(), 1'000, nullptr);
  for (std::uint32_t i = 1; i <= 11'000; ++i) {
    history.record(ended(i), 1'000 + 20 * i, nullptr);
    history.pump(1'000 + 20 * i);
  }
  flush(history);
  const HistoryText& effects = disk.effects();
  EXPECT_LT(lines_in(effects.full), EventHistory::kMaxEach + 100);
  EXPECT_LT(lines_in(effects.filling), EventHistory::kMaxEach + 100);
  EXPECT_GE(lines_in(effects.full) + lines_in(effects.filling), EventHistory::kMaxEach);
  EXPECT_EQ(newest(history, 10, {"state_changed"}).events.size(), 1u);
  const auto events = newest(history, 1000);
  EXPECT_EQ(events.events.back().event.effect, 11'000u);
  EXPECT_TRUE(events.more);
  std::size_t bytes = 0;
  for (const auto& event : events.events) bytes += protocol::encode_past_event(event).size();
  EXPECT_LT(bytes, 65'000u) << "an answer is a line that clients read";

  const EventHistory again(disk.writer(), disk.texts);
  EXPECT_EQ(newest(again, 1000), events);
  EXPECT_EQ(newest(again, 10, {"state_changed"}), newest(history, 10, {"state_changed"}));
}

TEST(History, TripsAreStoredAndRequestedSeparately) {
  Disk disk;
  EventHistory history(disk.writer(), {});
  history.record(tripped(), 1'000, nullptr, 17);
  protocol::Event latched = tripped();
  latched.current_a.reset();
  history.record(latched, 1'500, nullptr);
  for (std::int64_t i = 0; i < 6'000; ++i) {
    protocol::Event armed{.type = "state_changed", .time_ns = i};
    armed.state = "armed";
    history.record(armed, 2'000 + i, nullptr);
  }
  protocol::EventsHistory request;
  request.trips = true;
  request.limit = 1000;
  const auto decoded = [](const std::string& text) {
    return *protocol::decode_result<protocol::HistoryResult>(text);
  };
  const auto trips = decoded(history.newest(request, [](unsigned number) { return number == 17; }));
  ASSERT_EQ(trips.events.size(), 1u) << "not that it still was tripped";
  EXPECT_FALSE(trips.more);
  EXPECT_EQ(trips.events[0].recording, "trip-0017");
  EXPECT_EQ(decoded(history.newest(request)).events[0].recording, std::nullopt) << "it is gone";
  flush(history);
  const EventHistory again(disk.writer(), disk.texts);
  EXPECT_EQ(newest(again, 1, {"state_changed"}), newest(history, 1, {"state_changed"}));
  EXPECT_EQ(decoded(again.newest(request)).events.size(), 1u);
  EXPECT_EQ(again.last_recording(), 17u) << "named, so never given again";
}

TEST(History, IgnoresForeignLines) {
  Disk disk;
  disk.trips().filling = "hello\n\n{}\n[1,2]\n{\"at\":5}\n";
  disk.effects().filling =
      R"({"at":"2026-11-20T23:14:07.412Z","type":"effect_en)"
      "\n"
      R"({"at":"2026-11-20T23:14:07.412Z","type":"effect_ended","time_ns":1,"recording":"../x"})";
  const EventHistory history(disk.writer(), disk.texts);
  const auto events = newest(history, 10).events;
  ASSERT_EQ(events.size(), 1u);
  EXPECT_EQ(events[0].recording, std::nullopt);
}

TEST(History, AFullDiskQueueOrAFailingDiskIsRetried) {
  std::vector<std::string> requested;
  EventHistory history(
      [&](HistoryPart, const std::string& lines, bool) {
        requested.push_back(lines);
        return requested.size() == 1   ? nullptr
               : requested.size() == 2 ? done_work("no space left")
                                       : done_work();
      },
      {});
  history.record(ended(1), 1'000, nullptr);
  history.pump(1'000);
  history.record(ended(2), 2'000, nullptr);
  for (int second = 2; second < 9; ++second) history.pump(second * 1'000);
  ASSERT_EQ(requested.size(), 3u);
  EXPECT_EQ(lines_in(requested[0]), 1u);
  EXPECT_EQ(lines_in(requested[1]), 2u);
  EXPECT_EQ(requested[2], requested[1]);
}

TEST(History, PendingLinesOfAFullDiskQueueAreBounded) {
  Disk disk;
  bool capacity = false;
  EventHistory history(
      [&, write = disk.writer()](HistoryPart part, const std::string& lines, bool begin_file) {
        return capacity ? write(part, lines, begin_file) : nullptr;
      },
      {});
  for (std::uint32_t i = 1; i <= 6'000; ++i) history.record(ended(i), i, nullptr);
  EXPECT_FALSE(history.flush());
  capacity = true;
  flush(history);
  EXPECT_EQ(lines_in(disk.effects().filling), EventHistory::kMaxEach) << "the newest of them";
  EXPECT_NE(disk.effects().filling.find("\"effect\":6000,"), std::string::npos);
  EXPECT_EQ(disk.effects().full, "");
}

TEST(History, ATripDuringAnEarlierWriteWaitsForThatOnly) {
  std::vector<std::pair<HistoryPart, DiskWorkPtr>> jobs;
  EventHistory history(
      [&](HistoryPart part, const std::string&, bool) {
        jobs.emplace_back(part, std::make_shared<DiskWork>());
        return jobs.back().second;
      },
      {});
  history.record(ended(1), 1'000, nullptr);
  history.record(tripped(), 1'000, nullptr);
  history.pump(1'000);
  ASSERT_EQ(jobs.size(), 2u);
  EXPECT_EQ(jobs[0].first, HistoryPart::kTrips) << "before what matters less";
  history.record(tripped(), 1'001, nullptr);
  history.pump(1'001);
  EXPECT_EQ(jobs.size(), 2u);
  jobs[0].second->done = true;
  history.pump(1'002);
  ASSERT_EQ(jobs.size(), 3u) << "not a second later";
  EXPECT_EQ(jobs[2].first, HistoryPart::kTrips);
  jobs[2].second->problem = "no space left";
  jobs[2].second->done = true;
  for (int ms = 1'003; ms < 1'100; ++ms) history.pump(ms);
  EXPECT_EQ(jobs.size(), 3u) << "a disk that fails is asked once a second";
}

TEST(History, AClockThatWasSetBackHidesNoNewEvent) {
  Disk disk;
  {
    EventHistory history(disk.writer(), {});
    for (std::uint32_t i = 1; i <= 20; ++i) {
      history.record(ended(i), 9'000'000 + i, nullptr);
      history.record(tripped(), 9'000'000 + i, nullptr);
    }
    for (std::uint32_t i = 21; i <= 25; ++i) {
      history.record(ended(i), 1'000 * i, nullptr);
      history.record(tripped(), 1'000 * i, nullptr);
    }
    flush(history);
  }
  const EventHistory history(disk.writer(), disk.texts);
  const auto ends = newest(history, 10, {"effect_ended"}).events;
  ASSERT_EQ(ends.size(), 10u);
  EXPECT_EQ(ends.back().event.effect, 25u);
  EXPECT_EQ(ends.front().event.effect, 16u);
  EXPECT_EQ(newest(history, 2).events.back().at, base::rfc3339(25'000));
}

TEST(History, ALongLineHidesNoOther) {
  Disk disk;
  protocol::Event longest = ended(2);
  longest.slot = std::string(60'000, 'x');
  {
    EventHistory history(disk.writer(), {});
    history.record(ended(1), 1'000, nullptr);
    history.record(longest, 2'000, nullptr);
    flush(history);
  }
  const EventHistory history(disk.writer(), disk.texts);
  const auto events = newest(history, 10).events;
  ASSERT_EQ(events.size(), 1u);
  EXPECT_EQ(events[0].event.effect, 1u);
}

}  // namespace
}  // namespace hedgehog::server
