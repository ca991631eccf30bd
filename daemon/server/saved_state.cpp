// SPDX-License-Identifier: MIT
#include "daemon/server/saved_state.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "model/thermal_flow.h"

namespace hedgehog::server {
namespace {

using Json = nlohmann::json;

constexpr int kVersion = 1;
constexpr double kColdestC = -40.0;
constexpr double kHottestC = 200.0;
/// After two days nothing of the heat is left.
constexpr double kLongestS = 2.0 * 24 * 3600;

bool possible(double celsius) { return celsius >= kColdestC && celsius <= kHottestC; }

bool possible(const SavedState& s) {
  const auto& w = s.heat.winding_c;
  return std::isfinite(s.wall_time_s) && s.wall_time_s >= 0.0 && possible(s.room_c) &&
         possible(s.heat.core_c) &&
         std::all_of(w.begin(), w.end(), [](double c) { return possible(c); }) &&
         (!s.gain || (*s.gain >= 0.0 && *s.gain <= 1.0));
}

}  // namespace

std::string encode(const SavedState& s) {
  Json json{{"version", kVersion},
            {"wall_time_s", s.wall_time_s},
            {"heat_known", s.heat_known},
            {"measured", s.measured},
            {"winding_c", s.heat.winding_c},
            {"core_c", s.heat.core_c},
            {"room_c", s.room_c},
            {"latch", nullptr},
            {"clean_stop", s.clean_stop},
            {"gain", nullptr}};
  if (s.latch != control::Reason::kNone) {
    json["latch"] = control::name(s.latch);
  }
  if (s.gain) {
    json["gain"] = *s.gain;
  }
  return json.dump(2) + "\n";
}

std::optional<SavedState> decode_saved_state(std::string_view text) {
  const Json json = Json::parse(text, nullptr, false);
  SavedState s;
  try {
    if (json.at("version") != kVersion) {
      return std::nullopt;
    }
    json.at("wall_time_s").get_to(s.wall_time_s);
    json.at("heat_known").get_to(s.heat_known);
    json.at("measured").get_to(s.measured);
    json.at("winding_c").get_to(s.heat.winding_c);
    json.at("core_c").get_to(s.heat.core_c);
    json.at("room_c").get_to(s.room_c);
    json.at("clean_stop").get_to(s.clean_stop);
    if (const Json& latch = json.at("latch"); !latch.is_null()) {
      s.latch = control::reason_named(latch.get<std::string>());
      // A latch of another version still is a latch.
      s.latch = s.latch == control::Reason::kNone ? control::Reason::kInternal : s.latch;
    }
    if (const Json& gain = json.at("gain"); !gain.is_null()) {
      s.gain = gain.get<double>();
    }
  } catch (const Json::exception&) {
    return std::nullopt;
  }
  return possible(s) ? std::optional(s) : std::nullopt;
}

model::ThermalState decayed(const model::ThermalModel& model, model::ThermalState heat,
                            double room_c, double seconds) noexcept {
  model::HeatLoad load;
  load.room_c = room_c;
  const double total_s = std::clamp(seconds, 0.0, kLongestS);
  for (double t = 0.0; t < total_s;) {
    const double dt_s = std::min(1.0, total_s - t);
    heat = model::advanced(heat, model::heating_rates(model, heat, load), dt_s);
    t += dt_s;
  }
  return heat;
}

}  // namespace hedgehog::server
