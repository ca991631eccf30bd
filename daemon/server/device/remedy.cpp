// SPDX-License-Identifier: MIT
#include "daemon/server/device/remedy.h"

#include <cmath>

namespace hedgehog::server {
namespace {

using control::Reason;

constexpr const char* kCheckNamed = "Have the winding and the sensors that the trip names checked";

/// What to do before arming; empty: arming is enough.
std::string first_step(Reason reason, const RemedyFacts& facts) {
  switch (reason) {
    case Reason::kOverheated:
      return (facts.contradicted ? std::string(kCheckNamed) + "; let" : "Let") +
             " the ball cool below " + std::to_string(std::lround(facts.rearm_c)) + " °C";
    case Reason::kStateLost:
      return "The previous state of the ball is unknown (see the log): let it cool below " +
             std::to_string(std::lround(facts.rearm_c)) + " °C";
    case Reason::kBoardOverHeat:
    case Reason::kBoardHeatBudget:
      return "Let the ball cool";
    case Reason::kSensorOpen:
    case Reason::kSensorShort:
    case Reason::kSensorStale:
    case Reason::kSensorFrozen:
    case Reason::kSensorJump:
    case Reason::kSensorImplausible:
      return "Check the coil thermometer's plug and wire";
    case Reason::kSensorDisagrees:
      return "Check that the thermometer sits tight on its winding";
    case Reason::kUnexpectedCurrent:
    case Reason::kBoardStuckBridge:
    case Reason::kBridgeFault:
      return "Unplug the ball and have the bridges and current sensors of its board checked";
    case Reason::kCurrentMismatch:
      return "Check the plugs of the three coils, and r25_ohm in the device file";
    case Reason::kBoardOverCurrent:
      return "Check the coils for a short";
    case Reason::kMeasurementsDisagree:
      return kCheckNamed;
    case Reason::kFanStopped:
      return "Free the fan and check its plug";
    case Reason::kBoardSupply:
      return "Check the 12 V supply";
    case Reason::kThermometerLost:
      return "Plug in the second thermometer";
    case Reason::kThermometerDisagrees:
      return "Check that coil sensor and second thermometer both sit tight";
    case Reason::kShellHot:
      return "Let the ball's skin cool below 43 °C";
    case Reason::kTelemetryLost:
      return "Check the USB cable";
    case Reason::kInternal:
      return "Restart hedgehogd";
    case Reason::kBootLoader:
      return "Wait until the board has restarted in its boot loader";
    case Reason::kNone:
    case Reason::kNeverArmed:
    case Reason::kUncleanStop:
    case Reason::kHotPlug:
    case Reason::kEmergencyStop:
    case Reason::kNoBoard:
    case Reason::kBoardDeadMan:
      break;
  }
  return {};
}

}  // namespace

std::optional<std::string> remedy(control::State state, Reason reason, const RemedyFacts& facts) {
  if (state == control::State::kArmed) return std::nullopt;
  if (state == control::State::kAbsent) {
    if (reason == Reason::kBootLoader) {
      return facts.simulated ? "Wait until the simulated board is back, after 3 s"
                             : "The board is in its boot loader: hedgehogctl board flash FILE; or "
                               "unplug it and "
                               "plug it in again";
    }
    if (!facts.board_problem.empty()) return "The board is not used: " + facts.board_problem;
    return facts.simulated ? "Let the simulated board answer again: sim.set with an empty fault"
                           : "Plug in the ball, or run without one: hedgehogd --simulate";
  }
  std::string step = first_step(reason, facts);
  if (state == control::State::kTripped && facts.rearm_wait_s > 0.0) {
    step += (step.empty() ? "Wait " : ", wait ") +
            std::to_string(std::lround(std::ceil(facts.rearm_wait_s))) +
            " s (it was armed again after this trip " + std::to_string(facts.rearms) + " times)";
  }
  return step.empty() ? "Run: hedgehogctl arm" : step + ", then run: hedgehogctl arm";
}

std::string too_hot_remedy(double hottest_c, double skin_c, const model::Limits& limits) {
  const auto degrees = [](double celsius) { return std::to_string(std::lround(celsius)) + " °C"; };
  if (hottest_c > limits.sustain_c) {
    return "Wait until the hottest winding is below " + degrees(limits.sustain_c) +
           "; the upper bound of its temperature is " + degrees(hottest_c);
  }
  if (!std::isfinite(skin_c)) return "Wait until the temperature of the shell has been measured";
  return "Wait until the shell is cooler: the upper bound of its temperature is " + degrees(skin_c);
}

std::optional<std::string> reason_name(Reason reason) {
  if (reason == Reason::kNone) return std::nullopt;
  return std::string(control::name(reason));
}

}  // namespace hedgehog::server
