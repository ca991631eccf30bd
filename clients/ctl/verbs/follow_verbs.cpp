// SPDX-License-Identifier: MIT
#include "clients/ctl/verbs/follow_verbs.h"

#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "base/wall_time.h"
#include "clients/common/terminal.h"
#include "clients/common/text.h"
#include "clients/ctl/arguments/since_argument.h"
#include "clients/ctl/events/event_log.h"
#include "clients/ctl/screen/history_screen.h"
#include "clients/ctl/screen/watch_screen.h"
#include "clients/ctl/verbs/live.h"
#include "clients/lib/status_fields.h"

namespace hedgehog::client {

namespace {

constexpr double kRedrawHz = 10.0;

/// The state at the start, so that no output is not mistaken for a program that does not work.
void print_now(const protocol::EventsResult& now) {
  std::printf("  %s  %s%s, %s A allowed\n", time_of_day().c_str(), now.state.c_str(),
              now.reason ? (": " + *now.reason).c_str() : "", fixed(now.limit_a, 1).c_str());
  std::fflush(stdout);
}

/// Prints the events since `options.since`.
Outcome<protocol::HistoryResult> print_past(Session& session, const EventsOptions& options) {
  const auto since = since_rfc3339(*options.since, base::unix_ms_now());
  if (!since) return since.error();
  protocol::EventsHistory request{.since = *since, .types = options.types};
  request.limit = protocol::HistoryResult::kMaxEvents;
  const auto text = session.connection.call_text(request);
  if (!text) return text.error();
  auto past = protocol::decode_result<protocol::HistoryResult>(*text);
  if (!past) return ClientError{Failure::kProtocol, past.error().message, {}};
  if (session.json) {
    const auto history = nlohmann::ordered_json::parse(*text);
    for (const auto& event : history["events"]) std::puts(event.dump().c_str());
  } else {
    for (const std::string& line : history_screen(*past)) std::puts(line.c_str());
  }
  std::fflush(stdout);
  if (past->more) {
    std::fprintf(
        stderr,
        "hedgehogctl: only the newest %zu are shown; --types or a later --since shows what "
        "is missing\n",
        past->events.size());
  }
  return *std::move(past);
}

void print_lines(const std::vector<std::string>& lines) {
  for (const std::string& line : lines) std::puts(line.c_str());
  if (!lines.empty()) std::fflush(stdout);
}

/// Events between the subscription and the history request are in both.
bool is_among(const protocol::HistoryResult& past, const protocol::Event& event) {
  return std::any_of(
      past.events.begin(), past.events.end(),
      [&](const auto& one) {
        return one.event.type == event.type && one.event.time_ns == event.time_ns &&
               one.event.effect == event.effect;
      });
}

}  // namespace

int run_watch(Session& session) {
  if (!terminal_traits().picture) {
    return report_error({Failure::kBadAddress,
                         "watch draws a picture: it needs a terminal of 80 columns and 22 rows"});
  }
  auto ball = look(session.connection);
  if (!ball) return report_error(ball.error());
  const protocol::EventsSubscribe everything{{}, protocol::Scope::kAll};
  if (auto events = session.connection.call(everything); !events)
    return report_error(events.error());
  const protocol::TelemetrySubscribe request{kRedrawHz, protocol::kEveryStatusKey};
  if (auto telemetry = session.connection.call(request); !telemetry)
    return report_error(telemetry.error());
  WatchScreen screen(session.style);
  return follow_drawing(session, [&](const Notification& notification) -> std::vector<std::string> {
    if (const auto* telemetry = std::get_if<protocol::TelemetryMessage>(&notification)) {
      ball->status = telemetry->telemetry.status;
      screen.take(ball->status);
      screen.set_size(live_size());
      return screen.lines(*ball);
    }
    screen.take(std::get<protocol::EventMessage>(notification).event, time_of_day());
    return {};
  });
}

int run_events(Session& session, const EventsOptions& options) {
  if (auto hello = session.connection.hello("hedgehogctl"); !hello)
    return report_error(hello.error());
  const bool only_past = options.since && !options.follow;
  std::optional<protocol::EventsResult> now;
  if (!only_past) {
    // This program has no effects of its own, so all clients' effects are requested.
    const protocol::EventsSubscribe request{options.types, protocol::Scope::kAll};
    auto subscribed = session.connection.call(request);
    if (!subscribed) return report_error(subscribed.error());
    now = *std::move(subscribed);
  }
  Outcome<protocol::HistoryResult> past;
  if (options.since) {
    past = print_past(session, options);
    if (!past) return report_error(past.error());
  }
  if (!now) return kDone;
  if (!session.json) print_now(*now);
  EventLog log;
  const auto take = [&](const Notification& notification) {
    const auto* event = std::get_if<protocol::EventMessage>(&notification);
    if (event == nullptr || is_among(*past, event->event)) return true;
    print_lines(session.json ? std::vector{event->json}
                             : log.take(event->event, time_of_day(), EventLog::Clock::now()));
    return true;
  };
  const int code = follow(session, take, [&] { print_lines(log.due(EventLog::Clock::now())); });
  print_lines(log.rest());
  return code;
}

int run_telemetry(Session& session, const TelemetryOptions& options) {
  const auto fields = status_fields(options.fields);
  if (!fields) return report_error(fields.error());
  const protocol::TelemetrySubscribe request{options.rate_hz, *fields};
  if (auto hello = session.connection.hello("hedgehogctl"); !hello)
    return report_error(hello.error());
  if (auto subscribed = session.connection.call(request); !subscribed)
    return report_error(subscribed.error());
  std::int64_t count = 0;
  return follow(session, [&](const Notification& notification) {
    if (const auto* telemetry = std::get_if<protocol::TelemetryMessage>(&notification)) {
      std::puts(telemetry->json.c_str());
      std::fflush(stdout);
      ++count;
    }
    return options.count == 0 || count < options.count;
  });
}

}  // namespace hedgehog::client
