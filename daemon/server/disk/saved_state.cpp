// SPDX-License-Identifier: MIT
#include "daemon/server/disk/saved_state.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "base/parse_json.h"

namespace hedgehog::server {
namespace {

using Json = nlohmann::json;

constexpr int kVersion = 1;
constexpr std::size_t kLongestId = 64;
constexpr std::size_t kLongestSerial = 256;
constexpr double kMaxOhm = 100.0;
constexpr double kColdestC = -40.0;
constexpr double kHottestC = 200.0;

bool possible(double celsius) { return celsius >= kColdestC && celsius <= kHottestC; }

bool possible(const BootTime& time) {
  return std::isfinite(time.seconds) && time.seconds >= 0.0 && time.boot_id.size() <= kLongestId;
}

bool possible(const R25History& r25) {
  return r25.ohm >= 0.0 && r25.ohm <= kMaxOhm && r25.runs >= 0;
}

bool possible(const SavedState& s) {
  const auto& w = s.heat.winding_c;
  return std::all_of(s.r25.begin(), s.r25.end(), [](const auto& r25) { return possible(r25); }) &&
         possible(s.saved_at) && (!s.ball || s.ball->serial.size() <= kLongestSerial) &&
         possible(s.ambient_c) && possible(s.heat.core_c) &&
         std::all_of(w.begin(), w.end(), [](double c) { return possible(c); }) &&
         (!s.gain || (*s.gain >= 0.0 && *s.gain <= 1.0));
}

}  // namespace

std::string encode(const SavedState& s) {
  Json json{{"version", kVersion},
            {"boot_id", s.saved_at.boot_id},
            {"boot_time_s", s.saved_at.seconds},
            {"heat_known", s.heat_known},
            {"measured", s.measured},
            {"winding_c", s.heat.winding_c},
            {"core_c", s.heat.core_c},
            {"room_c", s.ambient_c},
            {"latch", nullptr},
            {"clean_stop", s.clean_stop},
            {"gain", nullptr}};
  if (s.latch != control::Reason::kNone) json["latch"] = control::name(s.latch);
  for (std::size_t i = 0; i < s.rearms.size(); ++i)
    if (s.rearms[i] > 0)
      json["rearms"][std::string(control::name(static_cast<control::Reason>(i)))] = s.rearms[i];
  for (const R25History& r25 : s.r25) json["r25"].push_back({{"ohm", r25.ohm}, {"runs", r25.runs}});
  if (s.ball) json["ball"] = {{"simulated", s.ball->simulated}, {"serial", s.ball->serial}};
  if (s.gain) json["gain"] = *s.gain;
  return json.dump(2) + "\n";
}

std::optional<SavedState> decode_saved_state(std::string_view text) {
  const auto parsed = base::parse_json<Json>(text);
  if (!parsed.good()) return std::nullopt;
  const Json& json = parsed.value;
  SavedState s;
  try {
    if (json.at("version") != kVersion) return std::nullopt;
    // Files from before 1.0 contain the time of day, from which no duration can be derived.
    if (json.contains("boot_id")) {
      json.at("boot_id").get_to(s.saved_at.boot_id);
      json.at("boot_time_s").get_to(s.saved_at.seconds);
    }
    json.at("heat_known").get_to(s.heat_known);
    json.at("measured").get_to(s.measured);
    json.at("winding_c").get_to(s.heat.winding_c);
    json.at("core_c").get_to(s.heat.core_c);
    json.at("room_c").get_to(s.ambient_c);
    json.at("clean_stop").get_to(s.clean_stop);
    if (json.contains("ball")) {
      const Json& ball = json.at("ball");
      s.ball = BallIdentity{ball.at("simulated").get<bool>(), ball.at("serial").get<std::string>()};
    }
    if (const Json& latch = json.at("latch"); !latch.is_null()) {
      s.latch = control::reason_named(latch.get<std::string>());
      // An unknown latch of another version is still a latch.
      s.latch = s.latch == control::Reason::kNone ? control::Reason::kInternal : s.latch;
    }
    if (json.contains("r25")) {
      for (std::size_t i = 0; i < s.r25.size(); ++i) {
        const Json& r25 = json.at("r25").at(i);
        s.r25[i] = {r25.at("ohm").get<double>(), r25.at("runs").get<int>()};
      }
    }
    if (json.contains("rearms")) {
      for (const auto& [reason, count] : json.at("rearms").items()) {
        const auto i = static_cast<std::size_t>(control::reason_named(reason));
        s.rearms[i] = static_cast<std::uint8_t>(std::clamp(count.get<int>(), 0, 255));
      }
    }
    if (const Json& gain = json.at("gain"); !gain.is_null()) s.gain = gain.get<double>();
  } catch (const Json::exception&) {
    return std::nullopt;
  }
  return possible(s) ? std::optional(s) : std::nullopt;
}

SavedState lost_state() {
  SavedState lost;
  lost.latch = control::Reason::kStateLost;
  return lost;
}

bool are_different(const BallIdentity& a, const BallIdentity& b) noexcept {
  return a.simulated != b.simulated ||
         (!a.serial.empty() && !b.serial.empty() && a.serial != b.serial);
}

}  // namespace hedgehog::server
