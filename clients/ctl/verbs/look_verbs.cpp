// SPDX-License-Identifier: MIT
#include "clients/ctl/verbs/look_verbs.h"

#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "clients/ctl/arguments/direction_argument.h"
#include "clients/ctl/screen/check_json.h"
#include "clients/ctl/screen/check_screen.h"
#include "clients/ctl/screen/devices_screen.h"
#include "clients/ctl/screen/forecast_screen.h"
#include "clients/ctl/screen/trips_screen.h"
#include "clients/ctl/terminal/words.h"

namespace hedgehog::client {

namespace {

using nlohmann::json;

void print(const std::vector<std::string>& lines) {
  for (const std::string& line : lines) std::puts(line.c_str());
}

/// Number of other connections; nullopt: the role does not permit the request.
std::optional<std::size_t> others_of(Connection& connection, const Ball& ball) {
  const auto list = connection.call(protocol::ConnectionList{});
  if (!list) return std::nullopt;
  return static_cast<std::size_t>(
      std::count_if(list->connections.begin(), list->connections.end(),
                    [&](const auto& info) { return info.connection != ball.hello.connection; }));
}

/// A user or process id; "-": not a Unix socket, or unknown.
std::string id_words(const std::optional<std::int64_t>& id) {
  return id ? std::to_string(*id) : "-";
}

int print_check(const Check& check, bool as_json) {
  std::puts(as_json ? check_json(check).c_str() : check.line.c_str());
  return check.code;
}

}  // namespace

int run_status(Session& session) {
  if (session.json) {
    const auto text = session.connection.call_text(protocol::DeviceStatus{});
    if (!text) return report_error(text.error());
    std::puts(text->c_str());
    return kDone;
  }
  const auto ball = look(session.connection);
  if (!ball) return report_error(ball.error());
  print(status_screen(*ball, session.style));
  return kDone;
}

int run_clients(Session& session) {
  if (auto hello = session.connection.hello("hedgehogctl"); !hello)
    return report_error(hello.error());
  const auto text = session.connection.call_text(protocol::ConnectionList{});
  if (!text) return report_error(text.error());
  if (session.json) {
    std::puts(text->c_str());
    return kDone;
  }
  const auto list = protocol::decode_result<protocol::ConnectionsResult>(*text);
  if (!list) return report_error({Failure::kProtocol, list.error().message, {}});
  const std::size_t name_columns = session.style.cuts ? 20 : std::string::npos;
  std::puts("    #  CLIENT                VIA   UID     PID      ROLE      SINCE         PLAYS");
  for (const protocol::ConnectionInfo& info : list->connections) {
    std::string plays;
    for (const protocol::EffectStatus& effect : info.effects)
      plays += (plays.empty() ? "" : ", ") + effect_words(effect);
    std::printf("%5lld  %s%s%s%s%s%s%s%s\n", static_cast<long long>(info.connection),
                left(cut(info.client.value_or("-"), name_columns) + "  ", 22).c_str(),
                left(info.transport, 6).c_str(), left(id_words(info.uid) + " ", 8).c_str(),
                left(id_words(info.pid) + " ", 9).c_str(),
                left(protocol::name(info.role), 10).c_str(),
                left(time_words(info.since_s), 14).c_str(), plays.empty() ? "-" : plays.c_str(),
                info.claimed ? "  (exclusive use)" : "");
  }
  return kDone;
}

int run_trips(Session& session) {
  protocol::EventsHistory request;
  request.trips = true;
  request.limit = protocol::HistoryResult::kMaxEvents;
  const auto text = session.connection.call_text(request);
  if (!text) return report_error(text.error());
  if (session.json) {
    std::puts(text->c_str());
    return kDone;
  }
  const auto history = protocol::decode_result<protocol::HistoryResult>(*text);
  if (!history) return report_error({Failure::kProtocol, history.error().message, {}});
  print(trips_screen(*history, session.style));
  return kDone;
}

int run_devices(Session& session) {
  const auto hello = session.connection.hello("hedgehogctl");
  if (!hello) return report_error(hello.error());
  const auto text = session.connection.call_text(protocol::DeviceList{});
  if (!text) return report_error(text.error());
  if (session.json) {
    std::puts(text->c_str());
    return kDone;
  }
  const auto list = protocol::decode_result<protocol::DevicesResult>(*text);
  if (!list) return report_error({Failure::kProtocol, list.error().message, {}});
  if (hello->device.simulated) std::printf("  %s is simulated\n", hello->device.name.c_str());
  print(devices_screen(*list, hello->device.name, session.style));
  return kDone;
}

int run_forecast(Session& session, const ForecastOptions& options) {
  json params{{"current_a", options.current_a}};
  if (!options.direction.empty()) {
    const auto direction = direction_json(options.direction);
    if (!direction) return report_error(direction.error());
    params["direction"] = json::parse(*direction);
  }
  const auto text = session.connection.call_raw("thermal.forecast", params.dump());
  if (!text) return report_error(text.error());
  if (session.json) {
    std::puts(text->c_str());
    return kDone;
  }
  const auto forecast = protocol::decode_result<protocol::ForecastResult>(*text);
  if (!forecast) return report_error({Failure::kProtocol, forecast.error().message, {}});
  print(forecast_screen(*forecast, options.current_a, options.direction));
  return kDone;
}

int run_check(const CommonOptions& options) {
  auto session = open_session(options);
  auto ball = session ? look(session->connection) : Outcome<Ball>(session.error());
  if (!ball) {
    const bool gone = ball.error().failure == Failure::kNoDaemon;
    if (!gone) return print_unknown(ball.error().message, options.json);
    return print_check({2, "HEDGEHOG CRITICAL - " + ball.error().message}, options.json);
  }
  return print_check(check_screen(*ball, others_of(session->connection, *ball)), options.json);
}

int print_unknown(const std::string& what, bool as_json) {
  return print_check({3, "HEDGEHOG UNKNOWN - " + what}, as_json);
}

}  // namespace hedgehog::client
