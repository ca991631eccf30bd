// SPDX-License-Identifier: MIT
#include "clients/ctl/events/event_words.h"

#include "clients/ctl/terminal/words.h"

namespace hedgehog::client {

std::string event_words(const protocol::Event& event) {
  std::string words = event.type;
  if (event.effect)
    words += "  #" + std::to_string(*event.effect) + (event.slot ? " " + *event.slot : "");
  if (event.state) words += "  " + *event.state;
  if (event.reason) words += (event.state ? ": " : "  ") + *event.reason;
  if (event.onset_ns && event.offset_ns)
    words += ", " + std::to_string((*event.offset_ns - *event.onset_ns) / 1'000'000) + " ms";
  if (event.delivered && event.delivered->mean < 0.995)
    words += ", " + fixed(100.0 * event.delivered->mean, 0) + " % of its strength";
  if (event.limit_a) words += "  " + fixed(*event.limit_a, 1) + " A allowed";
  if (event.temperature_c) words += " at " + fixed(*event.temperature_c, 1) + " °C";
  if (event.current_a) words += ", " + fixed(*event.current_a, 1) + " A";
  if (event.device) words += "  " + *event.device;
  if (event.skipped) words += "  " + std::to_string(*event.skipped) + " ticks skipped";
  return words + disagreement_words(event.disagreement);
}

std::string disagreement_words(const std::optional<protocol::Disagreement>& found) {
  if (!found || found->coil < 0 || found->coil > 2) return {};
  std::string words = std::string(" (winding ") + "xyz"[found->coil] + ":";
  for (const std::string& quantity : found->between)
    words += (words.back() == ':' ? " " : ", ") + quantity;
  return words + ")";
}

}  // namespace hedgehog::client
