// SPDX-License-Identifier: MIT
// Event history, kept over restarts: the newest trips, other events of the ball, deratings, effects
// and recurring events, as lines of JSON in memory and on disk. Each part has its own bound, so
// that frequent events of one do not displace those of another.
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

/// The two files of a part: the full one, and the one being filled.
struct HistoryText {
  std::string full;
  std::string filling;
};
using HistoryTexts = std::array<HistoryText, kHistoryParts>;

/// io thread only.
class EventHistory {
 public:
  static constexpr std::size_t kMaxEach = 5000;       // of each part, in memory and for the disk
  static constexpr std::size_t kMaxLineBytes = 4096;  // exceeds any event; longer lines are foreign
  static constexpr std::size_t kMaxAnswerBytes = 60'000;  // fits into one line with its frame

  /// Appends `lines` to the file being filled; `begin_file`: it first becomes the full one. Appends
  /// nothing on a problem. nullptr: the disk queue is full, to be retried.
  using Writer = std::function<DiskWorkPtr(HistoryPart, std::string lines, bool begin_file)>;
  using HasRecording = std::function<bool(unsigned number)>;  // the recording still exists

  /// `kept`: contents of the files; truncated and foreign lines are skipped.
  EventHistory(Writer writer, const HistoryTexts& kept);

  /// `effect`: for an event about one. `recording`: number of a trip's recording, 0: none.
  /// Replacing an effect in its slot, as a game does in every frame, is not recorded.
  void record(const protocol::Event& event, std::int64_t unix_ms, const Effect* effect,
              unsigned recording = 0);
  /// Passes pending events to the disk: trips at once, others and failed writes once a second.
  void pump(std::int64_t unix_ms);
  /// The same at once. True: all is on disk.
  bool flush();

  /// The result of events.history as JSON, limited to the size of a response.
  std::string newest(const protocol::EventsHistory& request,
                     const HasRecording& has_recording = {}) const;
  /// The highest number of a recording in an event; 0: none.
  unsigned last_recording() const noexcept { return last_recording_; }

 private:
  struct Entry {
    std::int64_t unix_ms = 0;
    std::int64_t last_ms = 0;  // of a series; else equal to unix_ms
    std::uint64_t number = 0;  // order of arrival
    std::size_t type = 0;
    bool trip = false;
    unsigned recording = 0;
    std::string json;  // without the recording
  };
  struct Part {
    std::deque<Entry> entries;
    std::uint64_t on_disk = 0;  // number of the last one on disk
    std::size_t lines_in_file = 0;
    std::vector<std::string> again;  // lines of series that have grown since they were written
    DiskWorkPtr work;
    std::size_t again_in_work = 0;
    std::uint64_t work_until = 0;
    std::size_t lines_after_work = 0;
  };

  void load(std::string_view text);
  void add(protocol::PastEvent&& event, std::int64_t unix_ms, unsigned recording);
  /// Adds `event` to the entry of its series; false: not recurring, or a new series.
  bool add_to_series(const protocol::PastEvent& event, std::int64_t unix_ms);
  /// A loaded `line` contains the whole of a series that an earlier line has started.
  bool completes_series(const protocol::PastEvent& line, std::int64_t unix_ms);
  void show_series(const EventSeries& series);
  /// Queues the lines of series that have grown and are due at `unix_ms`, or all of them.
  void write_series_again(std::int64_t unix_ms, bool at_once);
  Part& part_at(HistoryPart which) { return parts_[static_cast<std::size_t>(which)]; }
  void number_by_time();
  bool write(HistoryPart which);
  /// Adds the method and the client of the effect that `trip` has ended.
  void name_player(protocol::PastEvent& trip) const;

  Writer writer_;
  std::array<Part, kHistoryParts> parts_;
  /// The newest series of each type and disagreement (`series_key`).
  std::map<std::string, EventSeries> series_;
  std::uint64_t number_ = 0;
  std::int64_t written_ms_ = 0;
  unsigned last_recording_ = 0;
  bool urgent_ = false;
  struct Ended {
    std::int64_t time_ns = 0;
    std::optional<std::string> method;
    std::optional<std::string> client;
  };
  std::optional<Ended> tripped_;  // the last effect ended by a trip
};

}  // namespace hedgehog::server
