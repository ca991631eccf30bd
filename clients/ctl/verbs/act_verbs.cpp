// SPDX-License-Identifier: MIT
#include "clients/ctl/verbs/act_verbs.h"

#include <cstdio>
#include <nlohmann/json.hpp>
#include <string>

#include "clients/ctl/terminal/words.h"

namespace hedgehog::client {

int run_stop(Session& session) {
  const auto text = session.connection.call_text(protocol::DeviceEmergencyStop{});
  if (!text) return report_error(text.error());
  if (session.json) {
    std::puts(text->c_str());
    return kDone;
  }
  std::puts("The coils are off and stay off until: hedgehogctl arm");
  const auto stopped = protocol::decode_result<protocol::StateResult>(*text);
  if (stopped && !stopped->on_disk.value_or(true)) {
    std::fputs(
        "The stop is not on the daemon's disk (its log says why): the latch may be lost if the "
        "daemon is killed or power fails\n",
        stderr);
  }
  return kDone;
}

int run_arm(Session& session) {
  const auto text = session.connection.call_text(protocol::DeviceArm{});
  if (!text) return report_error(text.error());
  if (session.json) {
    std::puts(text->c_str());
    return kDone;
  }
  const auto status = session.connection.call(protocol::DeviceStatus{});
  if (!status) return report_error(status.error());
  const std::optional<double>& hottest = status->temperature_c.model;
  std::printf("%s is %s. Hottest winding %s, %s A allowed.\n", status->device.c_str(),
              status->state.c_str(),
              hottest ? (fixed(*hottest, 1) + " °C").c_str() : "at an unknown temperature",
              fixed(status->limit_a, 1).c_str());
  return kDone;
}

int run_gain(Session& session, std::optional<double> gain) {
  double set = 1.0;
  if (gain) {
    const auto result = session.connection.call(protocol::OutputSetGain{*gain});
    if (!result) return report_error(result.error());
    set = result->gain;
  } else {
    const auto description = session.connection.call(protocol::DeviceDescribe{});
    if (!description) return report_error(description.error());
    set = description->gain;
  }
  if (session.json) {
    std::puts(nlohmann::json{{"gain", set}}.dump().c_str());
  } else {
    const std::string two = fixed(set, 2);
    const std::string four = fixed(set, 4);
    std::printf("gain %s: every effect is scaled by it\n",
                (two + "00" == four ? two : four).c_str());
  }
  return kDone;
}

}  // namespace hedgehog::client
