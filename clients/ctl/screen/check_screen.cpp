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
  if (status.derating || status.limit_a < ball.hello.limits.current_a)
    return {1, "WARNING", is + ", derated"};
  if (!status.temperature_c.sensor) return {1, "WARNING", is + ", no temperature"};
  if (status.loop.lateness_us.p99 > kLateUs) return {1, "WARNING", is + ", its loop is late"};
  return {0, "OK", is};
}

std::string measures_of(const Ball& ball, const std::optional<double>& shown,
                        std::optional<std::size_t> clients) {
  const Status& status = ball.status;
  const protocol::LimitsDescription& limits = ball.description.limits;
  std::string text;
  if (shown) {
    text += "temperature=" + fixed(*shown, 1) + ";" + fixed(limits.derate_from_c, 0) + ";" +
            fixed(limits.trip_c, 0) + " ";
  }
  text += "current=" + fixed(current_norm_a(status), 1) + " limit=" + fixed(allowed_a(status), 1) +
          " effects=" + std::to_string(status.effects.size()) +
          " lateness=" + fixed(status.loop.lateness_us.p99, 0) + "us;" + fixed(kLateUs, 0);
  return clients ? text + " clients=" + std::to_string(*clients) : text;
}

}  // namespace

Check check_screen(const Ball& ball, std::optional<std::size_t> clients) {
  const Health health = health_of(ball);
  const auto& temperature = ball.status.temperature_c;
  const std::optional<double> shown = temperature.sensor ? temperature.sensor : temperature.model;
  return {health.code, std::string("HEDGEHOG ") + health.word + " - " + health.why +
                           (shown ? ", " + fixed(*shown, 1) + " C" : "") + ", " +
                           fixed(allowed_a(ball.status), 1) + " A allowed | " +
                           measures_of(ball, shown, clients)};
}

}  // namespace hedgehog::client
