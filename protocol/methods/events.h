// SPDX-License-Identifier: MIT
// events.*
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "protocol/method_info.h"
#include "protocol/methods/done.h"
#include "protocol/methods/effect.h"
#include "protocol/values/event.h"
#include "protocol/wire/fields.h"

namespace hedgehog::protocol {

/// State before the first event.
struct EventsResult {
  static constexpr std::string_view kSchema = "EventsSubscription";
  std::string state{};
  std::optional<std::string> reason{};
  bool derating = false;
  double limit_a = 0.0;

  void describe(Fields& f) {
    f.required("state", state);
    f.nullable("reason", reason);
    f.required("derating", derating);
    f.required("limit_a", limit_a);
  }
  friend bool operator==(const EventsResult&, const EventsResult&) = default;
};

struct EventsSubscribe {
  static constexpr MethodInfo kMethod{"events.subscribe", Role::kObserve,
                                      "Subscribes to notifications of events."};
  using Result = EventsResult;

  std::vector<std::string> types{};  // names of kEventTypes (values/event.h); empty: all
  Scope scope = Scope::kMine;        // selects effect events; device events are always sent

  void describe(Fields& f);
  friend bool operator==(const EventsSubscribe&, const EventsSubscribe&) = default;
};

struct EventsUnsubscribe {
  static constexpr MethodInfo kMethod{"events.unsubscribe", Role::kObserve,
                                      "Ends the subscription to events."};
  using Result = Done;
  friend bool operator==(const EventsUnsubscribe&, const EventsUnsubscribe&) = default;
};

/// An event of events.history, with the fields added for storage.
struct PastEvent {
  std::string at{};  // RFC 3339
  Event event{};
  // Effect events and trips: method and client of the effect; omitted if it has no client
  std::optional<std::string> method{};
  std::optional<std::string> client{};
  std::optional<std::string> recording{};  // trips: "trip-0017", while the recording exists
  // Series of events of one type: `event` is the first, with the sum of `skipped`
  std::optional<std::int64_t> count{};  // 2 and more
  std::optional<std::string> last{};    // RFC 3339

  void describe(Fields& f);
  friend bool operator==(const PastEvent&, const PastEvent&) = default;
};

struct HistoryResult {
  static constexpr std::string_view kSchema = "History";
  static constexpr std::int64_t kMaxEvents = 1000;
  std::vector<PastEvent> events{};  // oldest first
  bool more = false;                // older ones match too

  void describe(Fields& f) {
    f.required("events", events, {.items = kMaxEvents});
    f.required("more", more);
  }
  friend bool operator==(const HistoryResult&, const HistoryResult&) = default;
};

struct EventsHistory {
  static constexpr MethodInfo kMethod{"events.history", Role::kObserve,
                                      "Past events, including those before the last start."};
  using Result = HistoryResult;

  std::optional<std::string> since{};  // RFC 3339
  std::vector<std::string> types{};    // empty: all
  bool trips = false;                  // trips only
  std::int64_t limit = 100;            // 1..HistoryResult::kMaxEvents

  void describe(Fields& f);
  friend bool operator==(const EventsHistory&, const EventsHistory&) = default;
};

using EventsMethods = TypeList<EventsSubscribe, EventsUnsubscribe, EventsHistory>;

}  // namespace hedgehog::protocol
