// SPDX-License-Identifier: MIT
#include "clients/ctl/screen/check_screen.h"

#include "clients/ctl/terminal/words.h"

namespace hedgehog::client {

namespace {

using protocol::Status;

struct Health {
  int code;
  const char* word;
  std::string why;
};

Health health_of(const Ball& ball) {
  const Status& status = ball.status;
  const std::string is = status.device + " " + status.state;
  if (status.state == "tripped" || status.state == "absent")
    return {2, "CRITICAL", is + ": " + status.reason.value_or("")};
  if (status.state != "armed") return {1, "WARNING", is + ": " + status.reason.value_or("")};
  if (status.reason) return {1, "WARNING", is + ": " + *status.reason};
  if (status.derating || status.limit_a < ball.hello.limits.current_a)
    return {1, "WARNING", is + ", derated"};
  if (!status.temperature_c.model) return {1, "WARNING", is + ", no temperature"};
  if (!status.temperature_c.sensor)
    return {1, "WARNING", is + ", no temperature from its thermistor"};
  if (status.loop.lateness_us.p99 > kLateUs) return {1, "WARNING", is + ", its loop is late"};
  return {0, "OK", is};
}

std::string measures_of(const Ball& ball, std::optional<std::size_t> clients) {
  const Status& status = ball.status;
  const model::Limits& limits = ball.description.limits;
  std::string text;
  // The thresholds apply to the hottest winding; the thermistor, on one of them, has none.
  if (const auto& hottest = status.temperature_c.model) {
    text += "temperature=" + fixed(*hottest, 1) + ";" + fixed(limits.derate_from_c, 0) + ";" +
            fixed(limits.trip_c, 0) + " ";
  }
  if (const auto& sensor = status.temperature_c.sensor)
    text += "thermistor=" + fixed(*sensor, 1) + " ";
  text += "current=" + fixed(current_norm_a(status), 1) + " limit=" + fixed(allowed_a(status), 1) +
          " effects=" + std::to_string(status.effects.size()) +
          " lateness=" + fixed(status.loop.lateness_us.p99, 0) + "us;" + fixed(kLateUs, 0);
  return clients ? text + " clients=" + std::to_string(*clients) : text;
}

}  // namespace

Check check_screen(const Ball& ball, std::optional<std::size_t> clients) {
  const Health health = health_of(ball);
  const std::optional<double>& hottest = ball.status.temperature_c.model;
  return {health.code, std::string("HEDGEHOG ") + health.word + " - " + health.why +
                           (hottest ? ", hottest winding " + fixed(*hottest, 1) + " C" : "") +
                           ", " + fixed(allowed_a(ball.status), 1) + " A allowed | " +
                           measures_of(ball, clients)};
}

}  // namespace hedgehog::client
