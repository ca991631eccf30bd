// SPDX-License-Identifier: MIT
#include "clients/ctl/demo/tour_record.h"

#include <algorithm>
#include <utility>

#include "clients/ctl/screen/ball.h"
#include "clients/ctl/screen/ball_map.h"
#include "clients/ctl/terminal/words.h"

namespace hedgehog::client {

namespace {

constexpr double kZeroA = 0.1;
/// The request of the last chapter; after the warm start it is derated before the end.
constexpr double kLongPushA = 15.0;
/// Relative to the maximum: rising and falling currents are excluded.
constexpr double kStrongPart = 0.9;

long felt_pins(const protocol::Status& status) {
  return std::count_if(
      status.pins.force_n.begin(), status.pins.force_n.end(),
      [](double force_n) { return force_n >= kFeltN; });
}

}  // namespace

void TourRecord::take(const protocol::Status& status) {
  hottest_c_ = std::max(hottest_c_, status.temperature_c.model.value_or(0.0));
  min_limit_a_ = std::min(min_limit_a_, status.limit_a);
  if (status.pin && (pins_.empty() || pins_.back() != *status.pin)) pins_.push_back(*status.pin);
  max_felt_ = std::max(max_felt_, felt_pins(status));
  currents_a_.push_back(current_norm_a(status));
}

void TourRecord::take(const protocol::Event& event) {
  if (event.type == "state_changed" && event.state != "armed") {
    failures_.push_back("the ball is " + event.state.value_or("?") + ": " +
                        event.reason.value_or(""));
  }
  if (event.type == "effect_ended" && event.reason != "completed" && event.reason != "stopped")
    failures_.push_back("an effect ended " + event.reason.value_or("?"));
}

std::vector<std::int64_t> TourRecord::take_pins() { return std::exchange(pins_, {}); }

std::optional<double> TourRecord::take_current_a() {
  const std::vector<double> currents_a = std::exchange(currents_a_, {});
  if (currents_a.empty()) return std::nullopt;
  const double min_a = kStrongPart * *std::max_element(currents_a.begin(), currents_a.end());
  double sum_a = 0.0;
  int count = 0;
  for (const double current_a : currents_a) {
    if (current_a < min_a) continue;
    sum_a += current_a;
    ++count;
  }
  return sum_a / count;
}

long TourRecord::take_max_felt() { return std::exchange(max_felt_, 0); }

std::vector<std::string> TourRecord::failures(const protocol::Status& last, std::int64_t began_ns,
                                              bool starts_warm) const {
  std::vector<std::string> found = failures_;
  if (last.last_trip && last.last_trip->time_ns >= began_ns)
    found.push_back("tripped: " + last.last_trip->reason);
  if (starts_warm && !(min_limit_a_ < kLongPushA))
    found.push_back("the long push was never derated: " + fixed(min_limit_a_, 1) + " A at least");
  if (current_norm_a(last) > kZeroA)
    found.push_back(fixed(current_norm_a(last), 2) + " A flow after the end");
  return found;
}

}  // namespace hedgehog::client
