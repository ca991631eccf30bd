// SPDX-License-Identifier: MIT
#include "tests/vm/ball_log.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <stdexcept>

#include "tests/e2e/json_vector.h"
#include "tests/vm/bench.h"

namespace hedgehog::vm {
namespace {

constexpr double kQuietMs = 60'000;
// Every 61 ms: this samples all phases of the waves that games play, whose periods are round
// numbers.
constexpr double kTelemetryHz = 1000.0 / 61.0;
constexpr double kZeroCurrentA = 0.1;
// Minimum cosine of the angle between field and side.
constexpr double kSameSide = 0.99;

}  // namespace

BallLog::BallLog(const std::string& socket) : client_(socket) {
  client_.call("events.subscribe",
               {{"scope", "all"}, {"types", {"effect_started", "effect_ended"}}});
  client_.call("telemetry.subscribe",
               {{"rate_hz", kTelemetryHz}, {"fields", {"current_a", "field", "effects"}}});
}

PlayedEffect* BallLog::find(std::int64_t effect) {
  const auto at = std::find_if(played_.rbegin(), played_.rend(),
                               [&](const PlayedEffect& one) { return one.effect == effect; });
  return at == played_.rend() ? nullptr : &*at;
}

void BallLog::handle_event(const Json& event) {
  const auto effect = event["effect"].get<std::int64_t>();
  if (event["type"] == "effect_started") {
    PlayedEffect begun;
    begun.effect = effect;
    begun.slot = event.value("slot", "");
    played_.push_back(begun);
    return;
  }
  PlayedEffect* one = find(effect);
  if (one == nullptr) return;
  one->ended = event["reason"];
  if (event["onset_ns"].is_number() && event["offset_ns"].is_number())
    one->flowed_ms = 1e-6 * (event["offset_ns"].get<double>() - event["onset_ns"].get<double>());
}

void BallLog::handle_telemetry(const Json& telemetry) {
  current_a_ = norm(e2e::vector_of(telemetry["current_a"]));
  side_ = e2e::vector_of(telemetry["field"]);
  for (const Json& playing : telemetry["effects"]) {
    PlayedEffect* one = find(playing["effect"].get<std::int64_t>());
    if (one == nullptr) continue;
    one->method = playing["method"];
    one->peak_a = std::max(one->peak_a, current_a_);
    // The measured current follows the field some ticks later: in a fast wave much of it is
    // measured when the field is off again.
    if (current_a_ <= one->field_a || norm(side_) == 0.0) continue;
    if (current_a_ > kZeroCurrentA && norm(one->begun_at) == 0.0) one->begun_at = side_;
    one->field_a = current_a_;
    one->side = side_;
  }
}

void BallLog::read() {
  const auto line = client_.line();
  if (!line) throw std::runtime_error("the daemon tells nothing more");
  const Json message = Json::parse(*line);
  if (message.value("method", "") == "event") handle_event(message["params"]);
  if (message.value("method", "") == "telemetry") handle_telemetry(message["params"]);
}

bool BallLog::until(const std::function<bool()>& done) {
  const double from = now_ms();
  while (!done()) {
    if (now_ms() - from > kQuietMs) return false;
    read();
  }
  return true;
}

std::size_t BallLog::ended() const {
  return static_cast<std::size_t>(std::count_if(
      played_.begin(), played_.end(), [](const PlayedEffect& one) { return !one.ended.empty(); }));
}

bool BallLog::until_ended(std::size_t count) {
  return until([&] { return ended() >= count; });
}

bool BallLog::until_pushed(const model::Vec3& side, double current_a) {
  return until([&] { return dot(side_, side) > kSameSide && current_a_ > current_a; });
}

bool BallLog::until_still() {
  return until([&] { return current_a_ < kZeroCurrentA; });
}

std::string BallLog::text() const {
  std::string lines;
  for (const PlayedEffect& one : played_) {
    std::array<char, 160> line;
    std::snprintf(line.data(), line.size(),
                  "    %-5s %-8s %6.0f ms, peak %4.1f A at (%4.1f %4.1f %4.1f), %s\n",
                  one.slot.c_str(), one.method.c_str(), one.flowed_ms, one.peak_a, one.side.x,
                  one.side.y, one.side.z, one.ended.empty() ? "plays" : one.ended.c_str());
    lines += line.data();
  }
  return lines;
}

}  // namespace hedgehog::vm
