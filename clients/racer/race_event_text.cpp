// SPDX-License-Identifier: MIT
#include "clients/racer/race_event_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "model/geometry/direction.h"

namespace hedgehog::racer {

namespace {

std::string json(const Hit& hit) {
  const model::Vec3& d = hit.direction;
  return fmt::format(R"("hit","direction":[{:.9g},{:.9g},{:.9g}],"impulse_n_s":{:.9g})", d.x, d.y,
                     d.z, hit.impulse_n_s);
}
std::string json(const Landing& landing) {
  return fmt::format(R"("landing","impulse_n_s":{:.9g})", landing.impulse_n_s);
}
std::string json(const Skid& skid) { return fmt::format(R"("skid","amount":{:.9g})", skid.amount); }
std::string json(const Tumble& tumble) {
  const model::Vec3& d = tumble.down;
  return fmt::format(R"("tumble","down":[{:.9g},{:.9g},{:.9g}])", d.x, d.y, d.z);
}
std::string json(const LapDone& lap) {
  return fmt::format(R"("lap","lap":{},"lap_time_s":{:.9g})", lap.lap, lap.time_s);
}
std::string json(const Reset&) { return R"("reset")"; }

}  // namespace

std::string to_json(const RaceEvent& race_event, double time_s) {
  return fmt::format(R"({{"time_s":{:.9g},"type":{}}})", time_s,
                     std::visit([](const auto& what) { return json(what); }, race_event));
}

std::string side_of(const model::Vec3& direction) {
  constexpr std::array<const char*, 8> kSides{"front", "front left", "left",  "back left",
                                              "back",  "back right", "right", "front right"};
  const model::AzimuthElevation angles = model::angles_of(direction);
  if (std::abs(angles.elevation_deg) > 60.0) return angles.elevation_deg > 0.0 ? "roof" : "below";
  const auto eighth = static_cast<int>(std::lround(angles.azimuth_deg / 45.0));
  return kSides[static_cast<std::size_t>((eighth + 8) % 8)];
}

std::string RaceEventLog::ended(const char* what, const Lasting& lasting, double time_s) {
  return fmt::format("{:>7.2f} s  {}, {:.1f} s long, up to {:.0f} %", time_s, what,
                     time_s - lasting.since_s, 100.0 * lasting.max_amount);
}

std::vector<std::string> RaceEventLog::lines(const std::vector<RaceEvent>& race_events,
                                             double time_s) {
  std::vector<std::string> lines;
  bool skids = false;
  bool tumbles = false;
  for (const RaceEvent& race_event : race_events) {
    if (const auto* hit = std::get_if<Hit>(&race_event)) {
      lines.push_back(fmt::format("{:>7.2f} s  hit on the {}, {:.0f} N s", time_s,
                                  side_of(hit->direction), hit->impulse_n_s));
    } else if (const auto* landing = std::get_if<Landing>(&race_event)) {
      lines.push_back(fmt::format("{:>7.2f} s  landing, {:.0f} N s", time_s, landing->impulse_n_s));
    } else if (const auto* lap = std::get_if<LapDone>(&race_event)) {
      lines.push_back(fmt::format("{:>7.2f} s  lap {} in {:.2f} s", time_s, lap->lap, lap->time_s));
    } else if (std::holds_alternative<Reset>(race_event)) {
      lines.push_back(fmt::format("{:>7.2f} s  put back on the road", time_s));
    } else if (const auto* skid = std::get_if<Skid>(&race_event)) {
      skids = true;
      if (skid_.since_s < 0.0) skid_.since_s = time_s;
      skid_.max_amount = std::max(skid_.max_amount, skid->amount);
    } else if (const auto* tumble = std::get_if<Tumble>(&race_event)) {
      tumbles = true;
      if (tumble_.since_s < 0.0) tumble_.since_s = time_s;
      // Fraction of the angle from its wheels to its roof.
      const double over = std::acos(std::clamp(-tumble->down.z, -1.0, 1.0)) / std::acos(-1.0);
      tumble_.max_amount = std::max(tumble_.max_amount, over);
    }
  }
  if (!skids && skid_.since_s >= 0.0) {
    lines.push_back(ended("skid", skid_, time_s));
    skid_ = {};
  }
  if (!tumbles && tumble_.since_s >= 0.0) {
    lines.push_back(ended("turned over", tumble_, time_s));
    tumble_ = {};
  }
  return lines;
}

}  // namespace hedgehog::racer
