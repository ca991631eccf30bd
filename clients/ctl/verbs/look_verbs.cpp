// SPDX-License-Identifier: MIT
#include "clients/ctl/verbs/look_verbs.h"

#include <cstdio>
#include <nlohmann/json.hpp>

#include "clients/ctl/screen/words.h"
#include "clients/ctl/verbs/direction_argument.h"

namespace hedgehog::client {

namespace {

using nlohmann::json;
using protocol::Status;

void print(const std::vector<std::string>& lines) {
  for (const std::string& line : lines) {
    std::puts(line.c_str());
  }
}

std::string forecast_words(std::optional<double> seconds) {
  return seconds ? "in " + time_words(*seconds) : "never";
}

/// The plug-in's state word and exit code for `status`.
struct Health {
  int code = 3;
  const char* word = "UNKNOWN";
  std::string why;
};

Health health_of(const Ball& ball) {
  const Status& status = ball.status;
  if (status.state == "tripped" || status.state == "absent") {
    return {2, "CRITICAL", status.device + " " + status.state + ": " + status.reason.value_or("")};
  }
  if (status.state != "armed") {
    return {1, "WARNING", status.device + " " + status.state + ": " + status.reason.value_or("")};
  }
  if (status.derating || status.limit_a < ball.hello.limits.current_a) {
    return {1, "WARNING", status.device + " armed, derated"};
  }
  if (!status.temperature_c.sensor) {
    return {1, "WARNING", status.device + " armed, no temperature"};
  }
  return {0, "OK", status.device + " armed"};
}

}  // namespace

int run_status(Session& session) {
  if (session.json) {
    const auto text = session.connection.call_text(protocol::DeviceStatus{});
    if (!text) {
      return complain(text.error());
    }
    std::puts(text->c_str());
    return kDone;
  }
  const auto ball = look(session.connection);
  if (!ball) {
    return complain(ball.error());
  }
  print(status_screen(*ball, session.style));
  return kDone;
}

int run_clients(Session& session) {
  if (auto hello = session.connection.hello("hedgehogctl"); !hello) {
    return complain(hello.error());
  }
  const auto text = session.connection.call_text(protocol::ConnectionList{});
  if (!text) {
    return complain(text.error());
  }
  if (session.json) {
    std::puts(text->c_str());
    return kDone;
  }
  const auto list = protocol::decode_result<protocol::ConnectionsResult>(*text);
  if (!list) {
    return complain({Failure::kProtocol, list.error().message, {}});
  }
  std::puts("    #  CLIENT                VIA   ROLE      SINCE         PLAYS");
  for (const protocol::ConnectionInfo& info : list->connections) {
    std::string plays;
    for (const protocol::EffectStatus& effect : info.effects) {
      plays += (plays.empty() ? "" : ", ") + effect_words(effect);
    }
    std::printf("%5lld  %s%s%s%s%s%s\n", static_cast<long long>(info.connection),
                left(cut(info.client.value_or("-"), 20), 22).c_str(),
                left(info.transport, 6).c_str(), left(protocol::name(info.role), 10).c_str(),
                left(time_words(info.since_s), 14).c_str(), plays.empty() ? "-" : plays.c_str(),
                info.claimed ? "  (the ball is its alone)" : "");
  }
  return kDone;
}

int run_forecast(Session& session, const ForecastOptions& options) {
  json params{{"current_a", options.current_a}};
  if (!options.direction.empty()) {
    const auto direction = direction_json(options.direction);
    if (!direction) {
      return complain(direction.error());
    }
    params["direction"] = json::parse(*direction);
  }
  const auto text = session.connection.call_raw("thermal.forecast", params.dump());
  if (!text) {
    return complain(text.error());
  }
  if (session.json) {
    std::puts(text->c_str());
    return kDone;
  }
  const auto forecast = protocol::decode_result<protocol::ForecastResult>(*text);
  if (!forecast) {
    return complain({Failure::kProtocol, forecast.error().message, {}});
  }
  std::printf(
      "%s A from now, %s:\n", fixed(options.current_a, 1).c_str(),
      options.direction.empty() ? "on the coil that bears it least" : options.direction.c_str());
  std::printf("  derated     %s\n", forecast_words(forecast->seconds_to_derating).c_str());
  std::printf("  70 °C       %s, if nothing were reduced\n",
              forecast_words(forecast->seconds_to_limit).c_str());
  std::printf("  for ever    %s A\n", fixed(forecast->sustainable_a, 1).c_str());
  std::printf("  full again  %s\n", forecast->recovery_s && *forecast->recovery_s <= 0.0
                                        ? "now"
                                        : forecast_words(forecast->recovery_s).c_str());
  return kDone;
}

int run_check(const CommonOptions& options) {
  auto session = open_session(options);
  auto ball = session ? look(session->connection) : Outcome<Ball>(session.error());
  if (!ball) {
    const bool gone = ball.error().failure == Failure::kNoDaemon;
    std::printf("HEDGEHOG %s - %s\n", gone ? "CRITICAL" : "UNKNOWN", ball.error().message.c_str());
    return gone ? 2 : 3;
  }
  const Health health = health_of(*ball);
  const Status& status = ball->status;
  const auto& temperature = status.temperature_c;
  const std::optional<double> shown = temperature.sensor ? temperature.sensor : temperature.model;
  std::printf("HEDGEHOG %s - %s", health.word, health.why.c_str());
  if (shown) {
    std::printf(", %s C", fixed(*shown, 1).c_str());
  }
  std::printf(", %s A allowed | ", fixed(allowed_a(status), 1).c_str());
  if (shown) {
    const protocol::LimitsDescription& limits = ball->description.limits;
    std::printf("temperature=%s;%s;%s ", fixed(*shown, 1).c_str(),
                fixed(limits.derate_from_c, 0).c_str(), fixed(limits.trip_c, 0).c_str());
  }
  std::printf("current=%s limit=%s effects=%zu\n", fixed(current_norm_a(status), 1).c_str(),
              fixed(allowed_a(status), 1).c_str(), status.effects.size());
  return health.code;
}

}  // namespace hedgehog::client
