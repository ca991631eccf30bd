// SPDX-License-Identifier: MIT
#include "daemon/server/history/event_history.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <bitset>
#include <utility>
#include <vector>

#include "base/wall_time.h"
#include "daemon/server/history/trip_recordings.h"
#include "protocol/server_codec.h"

namespace hedgehog::server {
namespace {

constexpr std::int64_t kWriteEveryMs = 1000;
/// Maximum number of lines per job; joining more would delay io after a long disk failure.
constexpr std::size_t kMaxLines = 1000;
/// Maximum number of lines of series that wait for the disk; more would contain nothing new.
constexpr std::size_t kMaxAgain = 100;

/// Index in kEventTypes; its size for an unknown type.
std::size_t type_index(std::string_view type) {
  const auto& types = protocol::kEventTypes;
  return static_cast<std::size_t>(std::find(types.begin(), types.end(), type) - types.begin());
}
using Types = std::bitset<protocol::kEventTypes.size() + 1>;

Types wanted_types(const std::vector<std::string>& names) {
  Types types;
  for (const std::string& name : names) types.set(type_index(name));
  return names.empty() ? types.set() : types;
}

protocol::PastEvent as_past(const protocol::Event& event, std::int64_t unix_ms,
                            const Effect* effect) {
  protocol::PastEvent past{.at = base::rfc3339(unix_ms), .event = event};
  if (effect != nullptr) {
    past.method = std::string(protocol::name(effect->plan.spec.method));
    past.client = effect->client.empty() ? std::nullopt : std::optional(effect->client);
  }
  return past;
}

bool only_replaces(const protocol::Event& event, const Effect* effect) {
  const bool started = event.type == "effect_started";
  return started ? effect != nullptr && effect->replacing : event.reason == "replaced";
}

/// "measurement_rejected 1 heat_balance thermistor": events with the same key form a series.
std::string series_key(const protocol::Event& event) {
  if (!event.disagreement) return event.type;
  return fmt::format("{} {} {}", event.type, event.disagreement->coil,
                     fmt::join(event.disagreement->between, " "));
}

HistoryPart part_of(const protocol::Event& event) {
  return protocol::is_trip(event)             ? HistoryPart::kTrips
         : event.effect                       ? HistoryPart::kEffects
         : protocol::is_derating(event.type)  ? HistoryPart::kDerating
         : protocol::is_recurring(event.type) ? HistoryPart::kRecurring
                                              : HistoryPart::kBall;
}

/// `json` of an event, with the name of its recording appended as the last field.
std::string with_recording(std::string_view json, unsigned recording) {
  if (recording == 0) return std::string(json);
  json.remove_suffix(1);
  return std::string(json) + ",\"recording\":\"" + recording_name(recording) + "\"}";
}

}  // namespace

EventHistory::EventHistory(Writer writer, const HistoryTexts& kept) : writer_(std::move(writer)) {
  for (std::size_t i = 0; i < kHistoryParts; ++i) {
    const auto& [full, filling] = kept[i];
    load(full);
    load(filling);
    parts_[i].lines_in_file =
        static_cast<std::size_t>(std::count(filling.begin(), filling.end(), '\n'));
  }
  number_by_time();
  series_.clear();
}

void EventHistory::load(std::string_view text) {
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    if (line.empty() || line.size() > kMaxLineBytes) continue;
    auto event = protocol::decode_past_event(line);
    const auto at = event ? base::parse_rfc3339(event->at) : std::nullopt;
    if (at && !event->event.type.empty()) {
      const unsigned recording = recording_number(event->recording.value_or(""));
      if (!completes_series(*event, *at)) add(*std::move(event), *at, recording);
    }
  }
}

void EventHistory::number_by_time() {
  // Each part keeps its own order: after a clock was set back, new events may have older times.
  std::array<std::size_t, kHistoryParts> next{};
  for (;;) {
    Part* first = nullptr;
    std::size_t* at = nullptr;
    for (std::size_t i = 0; i < kHistoryParts; ++i) {
      const auto& entries = parts_[i].entries;
      if (next[i] < entries.size() &&
          (first == nullptr || entries[next[i]].unix_ms < first->entries[*at].unix_ms)) {
        first = &parts_[i];
        at = &next[i];
      }
    }
    if (first == nullptr) return;
    first->entries[(*at)++].number = first->on_disk = ++number_;
  }
}

void EventHistory::add(protocol::PastEvent&& event, std::int64_t unix_ms, unsigned recording) {
  if (add_to_series(event, unix_ms)) return;
  event.recording.reset();
  last_recording_ = std::max(last_recording_, recording);
  Part& part = part_at(part_of(event.event));
  const std::size_t type = type_index(event.event.type);
  part.entries.push_back({unix_ms, last_ms_of(event, unix_ms), ++number_, type,
                          protocol::is_trip(event.event), recording,
                          protocol::encode_past_event(event)});
  if (part.entries.size() > kMaxEach) part.entries.pop_front();
  if (!protocol::is_recurring(event.event.type)) return;
  write_series_again(unix_ms, true);
  std::string key = series_key(event.event);
  series_.insert_or_assign(std::move(key), EventSeries(std::move(event), unix_ms, number_));
}

bool EventHistory::add_to_series(const protocol::PastEvent& event, std::int64_t unix_ms) {
  const auto series = series_.find(series_key(event.event));
  if (series == series_.end() || !series->second.add(event, unix_ms)) return false;
  show_series(series->second);
  return true;
}

bool EventHistory::completes_series(const protocol::PastEvent& line, std::int64_t unix_ms) {
  const auto series = series_.find(series_key(line.event));
  if (series == series_.end() || !line.count || series->second.event().at != line.at) return false;
  series->second = EventSeries(line, unix_ms, series->second.number());
  show_series(series->second);
  return true;
}

void EventHistory::show_series(const EventSeries& series) {
  auto& entries = part_at(HistoryPart::kRecurring).entries;
  const auto entry = std::find_if(entries.rbegin(), entries.rend(),
                                  [&](const Entry& one) { return one.number == series.number(); });
  if (entry == entries.rend()) return;
  entry->last_ms = series.last_ms();
  entry->json = protocol::encode_past_event(series.event());
}

void EventHistory::write_series_again(std::int64_t unix_ms, bool at_once) {
  Part& part = part_at(HistoryPart::kRecurring);
  for (auto& [key, series] : series_) {
    // Until the first line is on disk, that line will contain the whole series.
    const bool written = series.number() <= part.on_disk;
    if (written && part.again.size() < kMaxAgain && series.take_due(unix_ms, at_once))
      part.again.push_back(protocol::encode_past_event(series.event()));
  }
}

void EventHistory::record(const protocol::Event& event, std::int64_t unix_ms, const Effect* effect,
                          unsigned recording) {
  if (only_replaces(event, effect)) return;
  protocol::PastEvent past = as_past(event, unix_ms, effect);
  if (event.effect && event.reason == "tripped")
    tripped_ = {event.time_ns, past.method, past.client};
  const HistoryPart which = part_of(event);
  if (which == HistoryPart::kTrips) {
    urgent_ = true;
    name_player(past);
  }
  add(std::move(past), unix_ms, recording);
  if (event.type == "shutting_down") write_series_again(unix_ms, true);
}

void EventHistory::name_player(protocol::PastEvent& trip) const {
  // Effects end in the tick of the trip, and are reported first.
  if (tripped_ && tripped_->time_ns == trip.event.time_ns) {
    trip.method = tripped_->method;
    trip.client = tripped_->client;
  }
}

void EventHistory::pump(std::int64_t unix_ms) {
  const bool due = unix_ms - written_ms_ >= kWriteEveryMs || unix_ms < written_ms_;
  if (urgent_ || due) {
    written_ms_ = unix_ms;
    write_series_again(unix_ms, false);
    flush();
  }
}

bool EventHistory::flush() {
  const Part& trips = parts_[static_cast<std::size_t>(HistoryPart::kTrips)];
  // Events received during a write are written right after it.
  urgent_ = urgent_ && trips.work && !trips.work->done.load(std::memory_order_acquire);
  bool all = write(HistoryPart::kTrips);
  for (const HistoryPart part :
       {HistoryPart::kBall, HistoryPart::kDerating, HistoryPart::kRecurring, HistoryPart::kEffects})
    all = write(part) && all;
  return all;
}

bool EventHistory::write(HistoryPart which) {
  Part& part = parts_[static_cast<std::size_t>(which)];
  if (part.work) {
    if (!part.work->done.load(std::memory_order_acquire)) return false;
    if (part.work->problem.empty()) {
      part.on_disk = part.work_until;
      part.again.erase(part.again.begin(),
                       part.again.begin() + static_cast<std::ptrdiff_t>(part.again_in_work));
      part.lines_in_file = part.lines_after_work;
    }
    part.work = nullptr;
  }
  auto from = std::find_if(part.entries.rbegin(), part.entries.rend(), [&](const Entry& entry) {
                return entry.number <= part.on_disk;
              }).base();
  if (from == part.entries.end() && part.again.empty()) return true;
  const bool begin_file = part.lines_in_file >= kMaxEach;
  part.lines_after_work = begin_file ? 0 : part.lines_in_file;
  part.work_until = part.on_disk;
  part.again_in_work = part.again.size();
  part.lines_after_work += part.again.size();
  std::string lines;
  for (const std::string& line : part.again) lines += line + '\n';
  for (std::size_t i = 0; i < kMaxLines && from != part.entries.end(); ++i, ++from) {
    lines += with_recording(from->json, from->recording) + '\n';
    part.work_until = from->number;
    ++part.lines_after_work;
  }
  part.work = writer_(which, std::move(lines), begin_file);
  return false;
}

std::string EventHistory::newest(const protocol::EventsHistory& request,
                                 const HasRecording& has_recording) const {
  const auto limit = static_cast<std::size_t>(request.limit);
  const std::int64_t since_ms = request.since ? base::parse_rfc3339(*request.since).value_or(0) : 0;
  const Types types = wanted_types(request.types);
  const auto wanted = [&](const Entry& entry) {
    return entry.last_ms >= since_ms && types[entry.type] && (entry.trip || !request.trips);
  };
  // One more than requested of each part, to detect whether there are more.
  std::vector<const Entry*> found;
  for (const Part& part : parts_) {
    std::size_t count = 0;
    for (auto it = part.entries.rbegin(); it != part.entries.rend() && count <= limit; ++it) {
      if (wanted(*it)) {
        found.push_back(&*it);
        ++count;
      }
    }
  }
  std::sort(found.begin(), found.end(),
            [](const Entry* a, const Entry* b) { return a->number > b->number; });
  std::vector<std::string> lines;
  std::size_t bytes = 0;
  for (const Entry* entry : found) {
    const bool recorded = entry->recording != 0 && has_recording && has_recording(entry->recording);
    std::string line = with_recording(entry->json, recorded ? entry->recording : 0);
    bytes += line.size() + 1;
    if (lines.size() == limit || bytes > kMaxAnswerBytes) break;
    lines.push_back(std::move(line));
  }
  const bool more = lines.size() < found.size();
  std::reverse(lines.begin(), lines.end());
  return protocol::encode_history(lines, more);
}

}  // namespace hedgehog::server
