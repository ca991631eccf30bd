// SPDX-License-Identifier: MIT
// Event history, kept over restarts: the newest trips, the newest other events of the ball, the
// newest deratings, the newest of effects, and what recurs, as lines of JSON in memory and on disk.
// Bounded separately, so that neither a game that plays sixty effects a second or a warm ball that
// is derated in each of them nor a loop that is late all day can displace the trips of last month,
// or yesterday's emergency stop.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "daemon/server/disk/disk_work.h"
#include "daemon/server/effects/effect_registry.h"
#include "daemon/server/history/event_series.h"
#include "protocol/methods.h"
#include "protocol/values/event.h"

namespace hedgehog::server {

/// In the order in which simultaneous events are reported.
enum class HistoryPart : std::uint8_t { kEffects, kTrips, kBall, kDerating, kRecurring };
inline constexpr std::size_t kHistoryParts = 5;

/// The two files of a part: a full one, and the one that is being filled.
struct HistoryText {
  std::string full;
  std::string filling;
};
using HistoryTexts = std::array<HistoryText, kHistoryParts>;

/// io thread only.
class EventHistory {
 public:
  /// Of each part, in memory and, at most, on the way to the disk.
  static constexpr std::size_t kMaxEach = 5000;
  /// No event is so long; foreign lines that are would hide what is older in every answer.
  static constexpr std::size_t kMaxLineBytes = 4096;
  /// An answer stays within what clients read as one line, with room for its frame.
  static constexpr std::size_t kMaxAnswerBytes = 60'000;

  /// Appends `lines` to the file that is being filled; `begin_file`: what is in it becomes the full
  /// one first. With a problem nothing was appended. nullptr: the disk has no room now, ask again.
  using Writer = std::function<DiskWorkPtr(HistoryPart, std::string lines, bool begin_file)>;
  /// True if the recording of that number still exists.
  using HasRecording = std::function<bool(unsigned number)>;

  /// `kept`: as the files are; torn and foreign lines are left out.
  EventHistory(Writer writer, const HistoryTexts& kept);

  /// `effect`: of an event about one. `recording`: number of a trip's, 0: there is none. What only
  /// replaces an effect in its slot, every frame of a game, is not kept.
  void record(const protocol::Event& event, std::int64_t unix_ms, const Effect* effect,
              unsigned recording = 0);
  /// Hands over to the disk what waits: trips at once, the rest, and again what the disk has
  /// refused, once a second.
  void pump(std::int64_t unix_ms);
  /// The same now. True: all is on disk.
  bool flush();

  /// The result of events.history as JSON: what fits an answer.
  std::string newest(const protocol::EventsHistory& request,
                     const HasRecording& has_recording = {}) const;
  /// The highest number of a recording that an event names; 0: none does.
  unsigned last_recording() const noexcept { return last_recording_; }

 private:
  struct Entry {
    std::int64_t unix_ms = 0;
    std::int64_t last_ms = 0;  // of a series; else the same
    std::uint64_t number = 0;  // in the order in which they came
    std::size_t type = 0;
    bool trip = false;
    unsigned recording = 0;
    std::string json;  // without the recording
  };
  struct Part {
    std::deque<Entry> entries;
    std::uint64_t on_disk = 0;  // number of the last one that is
    std::size_t lines_in_file = 0;
    std::vector<std::string> again;  // lines of series that have grown since they were written
    DiskWorkPtr work;
    std::size_t again_in_work = 0;
    std::uint64_t work_until = 0;
    std::size_t lines_after_work = 0;
  };

  void load(std::string_view text);
  void add(protocol::PastEvent&& event, std::int64_t unix_ms, unsigned recording);
  /// The entry of a series has grown by `event`; false: it is none, or a new one.
  bool add_to_series(const protocol::PastEvent& event, std::int64_t unix_ms);
  /// `line`, as it was loaded, tells the whole of a series that an earlier line has begun.
  bool completes_series(const protocol::PastEvent& line, std::int64_t unix_ms);
  void show_series(const EventSeries& series);
  /// Lines of series that have grown and are due at `unix_ms`, or at once.
  void write_series_again(std::int64_t unix_ms, bool at_once);
  Part& part_at(HistoryPart which) { return parts_[static_cast<std::size_t>(which)]; }
  void number_by_time();
  bool write(HistoryPart which);
  /// Who played what a trip at `time_ns` has ended.
  void name_player(protocol::PastEvent& trip) const;

  Writer writer_;
  std::array<Part, kHistoryParts> parts_;
  /// The newest of each type.
  std::map<std::size_t, EventSeries> series_;
  std::uint64_t number_ = 0;
  std::int64_t written_ms_ = 0;
  unsigned last_recording_ = 0;
  bool urgent_ = false;
  struct Ended {
    std::int64_t time_ns = 0;
    std::optional<std::string> method;
    std::optional<std::string> client;
  };
  /// The last effect that a trip has ended.
  std::optional<Ended> tripped_;
};

}  // namespace hedgehog::server
