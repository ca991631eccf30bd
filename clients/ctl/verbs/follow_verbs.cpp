// SPDX-License-Identifier: MIT
#include "clients/ctl/verbs/follow_verbs.h"

#include <cstdio>

#include "clients/ctl/screen/terminal.h"
#include "clients/ctl/screen/watch_screen.h"
#include "clients/ctl/screen/words.h"
#include "clients/ctl/verbs/live.h"

namespace hedgehog::client {

namespace {

constexpr double kRedrawHz = 10.0;

/// From where the events go on, so that a quiet ball is not taken for a deaf program.
void say_now(const protocol::EventsResult& now) {
  std::printf("  %s  %s%s, %s A allowed\n", time_of_day().c_str(), now.state.c_str(),
              now.reason ? (": " + *now.reason).c_str() : "", fixed(now.limit_a, 1).c_str());
  std::fflush(stdout);
}

}  // namespace

int run_watch(Session& session) {
  if (!terminal_traits().picture) {
    std::fputs(
        "hedgehogctl: watch draws a picture: it needs a terminal of 80 columns and 22 rows\n",
        stderr);
    return kUsage;
  }
  auto ball = look(session.connection);
  if (!ball) {
    return complain(ball.error());
  }
  const protocol::EventsSubscribe everything{{}, protocol::Scope::kAll};
  if (auto events = session.connection.call(everything); !events) {
    return complain(events.error());
  }
  const protocol::TelemetrySubscribe request{kRedrawHz, protocol::kEveryStatusKey};
  if (auto telemetry = session.connection.call(request); !telemetry) {
    return complain(telemetry.error());
  }
  WatchScreen screen(session.style);
  return follow_drawing(session, [&](const Notification& told) -> std::vector<std::string> {
    if (const auto* telemetry = std::get_if<protocol::TelemetryMessage>(&told)) {
      ball->status = telemetry->telemetry.status;
      screen.take(ball->status);
      return screen.lines(*ball);
    }
    screen.take(std::get<protocol::EventMessage>(told).event, time_of_day());
    return {};
  });
}

int run_events(Session& session, const EventsOptions& options) {
  // This program plays nothing, so effects of its own there are none.
  const protocol::EventsSubscribe request{options.types, protocol::Scope::kAll};
  if (auto hello = session.connection.hello("hedgehogctl"); !hello) {
    return complain(hello.error());
  }
  const auto subscribed = session.connection.call(request);
  if (!subscribed) {
    return complain(subscribed.error());
  }
  if (!session.json) {
    say_now(*subscribed);
  }
  return follow(session, [&](const Notification& told) {
    if (const auto* event = std::get_if<protocol::EventMessage>(&told)) {
      std::puts(session.json ? event->json.c_str()
                             : ("  " + time_of_day() + "  " + event_words(event->event)).c_str());
      std::fflush(stdout);
    }
    return true;
  });
}

int run_telemetry(Session& session, const TelemetryOptions& options) {
  protocol::TelemetrySubscribe request{options.rate_hz, protocol::kTelemetryDefault};
  if (!options.fields.empty()) {
    request.fields = {};
    for (const std::string& field : options.fields) {
      const auto key = protocol::status_key_named(field);
      if (!key) {
        std::fprintf(stderr, "hedgehogctl: fields: the status has no '%s'\n", field.c_str());
        return kUsage;
      }
      request.fields.add(*key);
    }
  }
  if (auto hello = session.connection.hello("hedgehogctl"); !hello) {
    return complain(hello.error());
  }
  if (auto subscribed = session.connection.call(request); !subscribed) {
    return complain(subscribed.error());
  }
  std::int64_t count = 0;
  return follow(session, [&](const Notification& told) {
    if (const auto* telemetry = std::get_if<protocol::TelemetryMessage>(&told)) {
      std::puts(telemetry->json.c_str());
      std::fflush(stdout);
      ++count;
    }
    return options.count == 0 || count < options.count;
  });
}

}  // namespace hedgehog::client
