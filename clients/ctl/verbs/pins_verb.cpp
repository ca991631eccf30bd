// SPDX-License-Identifier: MIT
#include "clients/ctl/verbs/pins_verb.h"

#include <cstdio>

#include "clients/common/terminal.h"
#include "clients/ctl/screen/ball_map.h"
#include "clients/ctl/screen/pins_screen.h"
#include "clients/ctl/terminal/words.h"
#include "clients/ctl/verbs/live.h"

namespace hedgehog::client {

namespace {

using protocol::Status;

constexpr double kPinsHz = 10.0;
/// Rate of lines for users.
constexpr double kLinesHz = 2.0;
/// For a single output the first notification should arrive quickly.
constexpr double kSoonHz = 50.0;

void print_once(const model::PinArray& pins, const Status& status, const ScreenStyle& style) {
  std::optional<model::Vec3> up;
  if (status.orientation) up = status.orientation->up;
  for (const std::string& line :
       ball_map(pins, status.pins.force_n, {.ascii = style.ascii, .world_up = up}))
    std::puts(line.c_str());
  const std::string legend = ball_map_legend(style.ascii);
  const std::string line =
      status.pin ? left(legend, 44) + aimed_pin_words(status) : std::string(legend);
  std::printf("    %s\n", line.c_str());
}

protocol::TelemetrySubscribe subscription(double rate_hz, bool pins_only) {
  if (!pins_only) return {rate_hz, protocol::kEveryStatusKey};
  protocol::StatusKeys pins;
  pins.add(protocol::StatusKey::kPins);
  return {rate_hz, pins};
}

int draw_pins(Session& session) {
  auto ball = look(session.connection);
  if (!ball) return report_error(ball.error());
  if (auto subscribed = session.connection.call(subscription(kPinsHz, false)); !subscribed)
    return report_error(subscribed.error());
  return follow_drawing(session, [&](const Notification& notification) {
    const auto* telemetry = std::get_if<protocol::TelemetryMessage>(&notification);
    if (telemetry == nullptr) return std::vector<std::string>{};
    ball->status = telemetry->telemetry.status;
    ScreenStyle style = session.style;
    style.columns = live_size().columns;
    return pins_screen(*ball, style);
  });
}

}  // namespace

int run_pins(Session& session, const PinsOptions& options) {
  if (options.live && options.count == 0 && !session.json && terminal_traits().picture)
    return draw_pins(session);
  model::PinArray pins;
  if (!options.live && !session.json) {
    auto ball = look(session.connection);
    if (!ball) return report_error(ball.error());
    pins = pin_array(ball->description);
  }
  const double rate_hz = !options.live ? kSoonHz : session.json ? kPinsHz : kLinesHz;
  if (auto subscribed = session.connection.call(subscription(rate_hz, session.json)); !subscribed)
    return report_error(subscribed.error());
  const std::int64_t wanted = options.live ? options.count : 1;
  std::int64_t count = 0;
  return follow(session, [&](const Notification& notification) {
    if (const auto* telemetry = std::get_if<protocol::TelemetryMessage>(&notification)) {
      if (session.json)
        std::puts(telemetry->json.c_str());
      else if (options.live)
        std::puts(pins_line(telemetry->telemetry.status).c_str());
      else
        print_once(pins, telemetry->telemetry.status, session.style);
      std::fflush(stdout);
      ++count;
    }
    return wanted == 0 || count < wanted;
  });
}

}  // namespace hedgehog::client
