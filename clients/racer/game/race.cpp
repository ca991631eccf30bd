// SPDX-License-Identifier: MIT
#include "clients/racer/game/race.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "clients/racer/game/car.h"
#include "clients/racer/game/impacts.h"
#include "clients/racer/game/laps.h"
#include "clients/racer/game/world.h"
#include "model/units.h"

namespace hedgehog::racer {

namespace {

// A hop over a kerb is not a flight.
constexpr double kFlightS = 0.2;
constexpr double kMinLanding = 400.0;  // Newton seconds: 0.5 m/s
// Below this speed, sliding wheels are not felt.
constexpr double kSlowSkid = 1.5;  // m/s
constexpr double kSkidBegins = 0.25;
constexpr double kSkidEnds = 0.1;
constexpr double kSkidSmoothing = 0.35;  // weight of the newest step: time constant about 40 ms
// Hysteresis of turning over, by the tilt of the car's up axis: cosines of 60 and 35 degrees.
constexpr double kTurnsOver = 0.5;
constexpr double kUpright = 0.82;
constexpr double kOverturnedS = 3.0;
constexpr double kMaxRestSpeed = 1.5;  // m/s
// Obstacles are restored in the next lap, unless the car is nearer than this.
constexpr double kResetDistanceM = 20.0;  // metres
constexpr double kLost = 15.0;            // metres beyond the edge of the road

double within(double value, double min, double max) {
  return std::isfinite(value) ? std::clamp(value, min, max) : 0.0;
}

}  // namespace

struct Race::State {
  explicit State(Track given) : track(std::move(given)), world(std::make_unique<World>(track)) {
    look();
  }

  void recover() {
    Pose pose = track.start;
    if (!track.centre.empty()) {
      const std::size_t count = track.centre.size();
      std::size_t at = nearest_point(track.centre, scene.car.position);
      for (std::size_t i = 0; i < count && !is_free(track.centre[at]); ++i)
        at = (at + count - 1) % count;
      const Vec3& here = track.centre[at];
      const Vec3 ahead = track.centre[(at + 1) % track.centre.size()] - here;
      pose =
          flat_pose(here.x, here.y, 0.0, std::atan2(ahead.y, ahead.x) * model::kDegreesPerRadian);
    }
    world->place(pose);
    flight_s = overturned_s = skid = 0.0;
    skids = tumbles = false;
    look();
  }

  /// True if no obstacle or ramp is at this place.
  bool is_free(const Vec3& place) const {
    constexpr double kApart = 2.0 * kCarHalfSize.x;
    const auto on = [&](const Ramp& ramp) {
      const Vec3 there = rotate(conjugate(ramp.pose.orientation), place - ramp.pose.position);
      return there.x > -kApart && there.x < ramp.length + kApart &&
             std::abs(there.y) < 0.5 * ramp.width + kCarHalfSize.y;
    };
    const auto beside = [&](const Pose& obstacle) {
      return std::hypot(obstacle.position.x - place.x, obstacle.position.y - place.y) < kApart;
    };
    return std::none_of(track.ramps.begin(), track.ramps.end(), on) &&
           std::none_of(scene.obstacles.begin(), scene.obstacles.end(), beside);
  }

  /// Updates the scene from the world.
  void look() {
    scene.car = world->car();
    scene.wheels = world->wheels();
    scene.obstacles = world->obstacles();
    scene.speed_mps = dot(world->velocity(), rotate(scene.car.orientation, {1, 0, 0}));
    scene.lap_time_s = driven ? scene.time_s - lap_started_s : 0.0;
  }

  void step(const Controls& asked) {
    race_events.clear();
    if (reset_requested) race_events.emplace_back(Reset{});
    reset_requested = false;
    scene.controls = {.steer = within(asked.steer, -1, 1),
                      .throttle = within(asked.throttle, 0, 1),
                      .brake = within(asked.brake, 0, 1)};
    if (!driven && scene.controls != Controls{}) {
      driven = true;
      lap_started_s = scene.time_s;
    }
    std::vector<Contact> contacts;
    for (int i = 0; i < 2; ++i) {
      world->step(scene.controls);
      const std::vector<Contact> now = world->contacts();
      contacts.insert(contacts.end(), now.begin(), now.end());
    }
    scene.time_s += kStepS;
    look();
    for (const Hit& hit : impacts.take(contacts, scene.time_s)) race_events.emplace_back(hit);
    detect_landing(contacts);
    detect_skid();
    detect_tumble(!contacts.empty());
    detect_lap();
  }

  void detect_landing(const std::vector<Contact>& contacts) {
    const bool grounded =
        !contacts.empty() || std::any_of(scene.wheels.begin(), scene.wheels.end(),
                                         [](const Wheel& wheel) { return wheel.contact; });
    const bool upright = up() > kTurnsOver;
    // The velocity of the previous step, because the springs have begun to absorb it in this one.
    if (grounded && flight_s > kFlightS && upright && kCarMassKg * fall_mps > kMinLanding)
      race_events.emplace_back(Landing{kCarMassKg * fall_mps});
    flight_s = grounded ? 0.0 : flight_s + kStepS;
    fall_mps = std::max(0.0, -world->velocity().z);
  }

  void detect_skid() {
    double sum = 0.0;
    for (const Wheel& wheel : scene.wheels) sum += wheel.skid;
    const Vec3 velocity = world->velocity();
    const double speed = std::hypot(velocity.x, velocity.y);
    const double now = speed < kSlowSkid ? 0.0 : sum / 4.0;
    skid += kSkidSmoothing * (now - skid);
    skids = skid > (skids ? kSkidEnds : kSkidBegins);
    if (skids) race_events.emplace_back(Skid{std::min(skid, 1.0)});
  }

  void detect_tumble(bool touches) {
    tumbles = tumbles ? up() < kUpright : up() < kTurnsOver;
    if (tumbles)
      race_events.emplace_back(Tumble{rotate(conjugate(scene.car.orientation), {0, 0, -1})});
    const bool overturned = tumbles && touches && norm(world->velocity()) < kMaxRestSpeed;
    overturned_s = overturned ? overturned_s + kStepS : 0.0;
    if (overturned_s > kOverturnedS || lost()) {
      recover();
      reset_requested = true;
    }
  }

  bool lost() const {
    if (track.centre.empty()) return false;
    const Vec3& here = scene.car.position;
    const Vec3 away = track.centre[nearest_point(track.centre, here)] - here;
    return std::hypot(away.x, away.y) > 0.5 * track.width + kLost || here.z < -5.0;
  }

  void detect_lap() {
    if (!laps.take(track.centre, scene.car.position)) return;
    const double time_s = scene.time_s - lap_started_s;
    race_events.emplace_back(LapDone{laps.done(), time_s});
    scene.last_lap_s = time_s;
    scene.best_lap_s = std::min(time_s, scene.best_lap_s.value_or(time_s));
    lap_started_s = scene.time_s;
    scene.lap = laps.done() + 1;
    scene.lap_time_s = 0.0;
    world->reset_objects(kResetDistanceM);
  }

  /// Cosine of the car's tilt.
  double up() const { return rotate(scene.car.orientation, {0, 0, 1}).z; }

  Track track;
  std::unique_ptr<World> world;
  Scene scene;
  std::vector<RaceEvent> race_events;
  Impacts impacts;
  Laps laps;
  double flight_s = 0.0;
  double fall_mps = 0.0;
  double skid = 0.0;
  bool skids = false;
  bool tumbles = false;
  double overturned_s = 0.0;
  /// The player has begun to drive: until then the lap time stands still.
  bool driven = false;
  double lap_started_s = 0.0;
  bool reset_requested = false;
};

Race::Race(Track track) : state_(std::make_unique<State>(std::move(track))) {}
Race::Race(Race&&) noexcept = default;
Race& Race::operator=(Race&&) noexcept = default;
Race::~Race() = default;

const Scene& Race::step(const Controls& controls) {
  state_->step(controls);
  return state_->scene;
}
const Scene& Race::scene() const noexcept { return state_->scene; }
const std::vector<RaceEvent>& Race::race_events() const noexcept { return state_->race_events; }
const Track& Race::track() const noexcept { return state_->track; }

void Race::recover() {
  state_->recover();
  state_->reset_requested = true;
}

}  // namespace hedgehog::racer
