// SPDX-License-Identifier: MIT
#include "clients/ctl/verbs/act_verbs.h"

#include <cstdio>

#include "clients/ctl/terminal/words.h"

namespace hedgehog::client {

int run_stop(Session& session) {
  const auto text = session.connection.call_text(protocol::DeviceEmergencyStop{});
  if (!text) return complain(text.error());
  if (session.json)
    std::puts(text->c_str());
  else
    std::puts("The coils are off and stay off until: hedgehogctl arm");
  return kDone;
}

int run_arm(Session& session) {
  const auto text = session.connection.call_text(protocol::DeviceArm{});
  if (!text) return complain(text.error());
  if (session.json) {
    std::puts(text->c_str());
    return kDone;
  }
  const auto status = session.connection.call(protocol::DeviceStatus{});
  if (!status) return complain(status.error());
  const auto& temperature = status->temperature_c;
  const auto shown = temperature.sensor ? temperature.sensor : temperature.model;
  std::printf("%s is %s. %s °C, %s A allowed.\n", status->device.c_str(), status->state.c_str(),
              shown ? fixed(*shown, 1).c_str() : "?", fixed(status->limit_a, 1).c_str());
  return kDone;
}

int run_gain(Session& session, std::optional<double> gain) {
  double set = 1.0;
  if (gain) {
    const auto result = session.connection.call(protocol::OutputSetGain{*gain});
    if (!result) return complain(result.error());
    set = result->gain;
  } else {
    const auto description = session.connection.call(protocol::DeviceDescribe{});
    if (!description) return complain(description.error());
    set = description->gain;
  }
  std::printf(session.json ? "{\"gain\":%s}\n" : "gain %s: every effect is scaled by it\n",
              fixed(set, 2).c_str());
  return kDone;
}

}  // namespace hedgehog::client
