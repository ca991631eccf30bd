// SPDX-License-Identifier: MIT
#include "clients/racer/server/messages.h"

#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "base/parse_json.h"
#include "clients/racer/game/car.h"

namespace hedgehog::racer {
namespace {

using Json = nlohmann::json;

constexpr std::array<std::pair<Mode, std::string_view>, 3> kModes{
    {{Mode::kBall, "ball"}, {Mode::kKeyboard, "keyboard"}, {Mode::kDriver, "driver"}}};

/// A tenth of a millimetre is sufficient for display.
double rounded(double value) { return std::round(value * 1e4) / 1e4; }

Json of(const Vec3& v) { return Json::array({rounded(v.x), rounded(v.y), rounded(v.z)}); }

Json of(const Quaternion& q) {
  return Json::array({rounded(q.w), rounded(q.x), rounded(q.y), rounded(q.z)});
}

Json of(const Pose& pose) { return {{"at", of(pose.position)}, {"turn", of(pose.orientation)}}; }

Json of(const std::optional<double>& value) { return value ? Json(rounded(*value)) : Json(); }

std::string_view name(Shape shape) {
  switch (shape) {
    case Shape::kDrum:
      return "drum";
    case Shape::kBall:
      return "ball";
    case Shape::kBox:
      break;
  }
  return "box";
}

template <class Things, class Describe>
Json list_of(const Things& things, Describe describe) {
  Json list = Json::array();
  for (const auto& thing : things) list.push_back(describe(thing));
  return list;
}

Json with(const Pose& pose, Json more) {
  more.update(of(pose));
  return more;
}

/// A number of `message` in [lowest, 1]; `why` is set if it is invalid.
double number_in(const Json& message, const char* key, double lowest, std::string& why) {
  const auto found = message.find(key);
  if (found == message.end()) return 0.0;
  const double value = found->is_number() ? found->get<double>() : std::nan("");
  if (value >= lowest && value <= 1.0) return value;
  why = std::string(key) + " must be " + (lowest < 0.0 ? "-1 to 1" : "0 to 1");
  return 0.0;
}

PageMessage keys(const Json& message) {
  std::string why;
  const Controls controls{number_in(message, "steer", -1.0, why),
                          number_in(message, "throttle", 0.0, why),
                          number_in(message, "brake", 0.0, why)};
  if (!why.empty()) return InvalidMessage{why};
  return KeysHeld{controls};
}

PageMessage pause(const Json& message) {
  const auto on = message.find("on");
  if (on == message.end() || !on->is_boolean()) return InvalidMessage{"on must be true or false"};
  return PauseRequest{on->get<bool>()};
}

PageMessage mode(const Json& message) {
  const auto wanted = message.find("mode");
  const auto found = wanted != message.end() && wanted->is_string()
                         ? mode_of(wanted->get_ref<const std::string&>())
                         : std::nullopt;
  if (!found) return InvalidMessage{"mode must be ball, keyboard or driver"};
  return ModeRequest{*found};
}

}  // namespace

std::string_view name(Mode mode) noexcept { return kModes[static_cast<std::size_t>(mode)].second; }

std::optional<Mode> mode_of(std::string_view name) noexcept {
  for (const auto& [mode, word] : kModes)
    if (word == name) return mode;
  return std::nullopt;
}

std::string track_text(const Track& track) {
  const Json text = {
      {"type", "track"},
      {"centre", list_of(track.centre, [](const Vec3& point) { return of(point); })},
      {"width", track.width},
      {"walls", list_of(track.walls,
                        [](const Wall& wall) {
                          return with(wall.pose, {{"half", of(wall.half_size)}});
                        })},
      {"obstacles",
       list_of(
           track.obstacles,
           [](const Obstacle& thing) {
             return with(thing.pose, {{"shape", name(thing.shape)}, {"half", of(thing.half_size)}});
           })},
      {"ramps", list_of(track.ramps,
                        [](const Ramp& ramp) {
                          return with(ramp.pose, {{"length", ramp.length},
                                                  {"width", ramp.width},
                                                  {"height", ramp.height}});
                        })},
      {"patches", list_of(track.patches,
                          [](const Patch& patch) {
                            return with(patch.pose,
                                        {{"half", {patch.half_length, patch.half_width}},
                                         {"grip", patch.grip}});
                          })},
      {"start", of(track.start)},
      {"car",
       {{"half", of(kCarHalfSize)},
        {"lift", kCarBodyLift},
        {"wheel_radius", kWheelRadius},
        {"wheel_width", kWheelWidth}}}};
  return text.dump();
}

std::string scene_text(const Scene& scene, const GameStatus& stand) {
  const Json text = {
      {"type", "scene"},
      {"time_s", rounded(scene.time_s)},
      {"car", of(scene.car)},
      {"wheels",
       list_of(
           scene.wheels,
           [](const Wheel& wheel) {
             return with(wheel.pose, {{"contact", wheel.contact}, {"skid", rounded(wheel.skid)}});
           })},
      {"obstacles", list_of(scene.obstacles, [](const Pose& pose) { return of(pose); })},
      {"speed_mps", rounded(scene.speed_mps)},
      {"steer", rounded(scene.controls.steer)},
      {"throttle", rounded(scene.controls.throttle)},
      {"brake", rounded(scene.controls.brake)},
      {"lap", scene.lap},
      {"lap_s", rounded(scene.lap_time_s)},
      {"last_s", of(scene.last_lap_s)},
      {"best_s", of(stand.best_lap_s)},
      {"mode", name(stand.mode)},
      {"paused", stand.paused}};
  return text.dump();
}

std::string ball_text(const BallView& ball) {
  const Json text = {{"type", "ball"},
                     {"connected", ball.connected},
                     {"simulated", ball.simulated},
                     {"state", ball.state},
                     {"temperature_c", of(ball.temperature_c)},
                     {"limit_a", of(ball.limit_a)},
                     {"budget", of(ball.budget)},
                     {"gain", rounded(ball.gain)},
                     {"derated", ball.derated},
                     {"reason", ball.reason}};
  return text.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string felt_text(const Felt& felt) {
  return Json{{"type", "felt"},
              {"kind", felt.kind},
              {"direction", of(felt.direction)},
              {"strength", rounded(felt.strength)},
              {"level_a", rounded(felt.level_a)}}
      .dump();
}

std::string lap_text(const FinishedLap& lap) {
  return Json{{"type", "lap"},
              {"lap", lap.lap},
              {"time_s", rounded(lap.time_s)},
              {"best", lap.best},
              {"driver", lap.driver}}
      .dump();
}

std::string shutdown_text(std::string_view reason) {
  return Json{{"type", "goodbye"}, {"reason", reason}}.dump();
}

std::string refusal_text(std::string_view why) {
  return Json{{"type", "refused"}, {"why", why}}.dump(-1, ' ', false,
                                                      Json::error_handler_t::replace);
}

PageMessage page_message(std::string_view text) {
  const Json message = base::parse_json<Json>(text).value;
  const auto type = message.is_object() ? message.find("type") : message.end();
  if (!message.is_object() || type == message.end() || !type->is_string())
    return InvalidMessage{"send one JSON object with a type"};
  const std::string& word = type->get_ref<const std::string&>();
  if (word == "keys") return keys(message);
  if (word == "reset") return ResetRequest{};
  if (word == "pause") return pause(message);
  if (word == "mode") return mode(message);
  return InvalidMessage{"type must be keys, reset, pause or mode"};
}

}  // namespace hedgehog::racer
