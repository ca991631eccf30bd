// SPDX-License-Identifier: MIT
#include "daemon/server/rpc/view/status_view.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "daemon/server/effects/admission.h"
#include "daemon/server/rpc/view/event_view.h"
#include "model/geometry/field.h"
#include "model/geometry/pin_motion.h"
#include "model/thermal/thermal_flow.h"

namespace hedgehog::server {
namespace {

using control::StatusSnapshot;

constexpr model::Tick kForecastPeriod = 50;
/// Below this the direction of the current is noise.
constexpr double kFlowsA = 0.05;

std::optional<double> finite(double value) {
  return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

/// Readings of all windings; nullopt unless each has a valid one.
std::optional<std::array<double, 3>> thermistors(const device::BoardTelemetry& board) {
  std::array<double, 3> shown_c{};
  if (board.thermistors < static_cast<int>(shown_c.size())) return std::nullopt;
  for (std::size_t i = 0; i < shown_c.size(); ++i) {
    const device::Thermistor one = device::thermistor_on(board, static_cast<int>(i));
    if (one.state != device::ThermistorState::kRead || !std::isfinite(one.celsius))
      return std::nullopt;
    shown_c[i] = one.celsius;
  }
  return shown_c;
}

protocol::TemperatureStatus temperature(const StatusSnapshot& s, int sensor_winding, bool known) {
  protocol::TemperatureStatus t;
  if (s.sensor_valid) t.sensor = finite(thermistor_on(s.board, sensor_winding).celsius);
  if (known) {
    t.model = finite(model::hottest_winding(s.thermal.nodes));
    t.upper = finite(s.thermal.hottest_c);
    t.core = finite(s.thermal.nodes.core_c);
    t.skin = finite(s.skin.bound_c);
  }
  t.coils = s.thermal.nodes.winding_c;
  t.sensors = thermistors(s.board);
  if (s.board_present) t.age_ms = std::llround(1000.0 * s.sensor_age_s);
  if (s.thermometer_known) t.thermometer = finite(s.thermometer_c);
  return t;
}

protocol::OrientationStatus orientation(const StatusSnapshot& s) {
  protocol::OrientationStatus o;
  o.quaternion = s.orientation;
  o.up = model::rotate(model::conjugate(s.orientation), {0, 0, 1});
  o.rate_deg_s = s.orientation_rate_deg_s;
  o.age_ms = s.orientation_age;
  return o;
}

protocol::LoopStatus loop(const control::LoopStatistics& l) {
  return {l.rate_hz, l.ticks, l.skipped, {l.lateness_p50_us, l.lateness_p99_us, l.lateness_max_us}};
}

}  // namespace

model::Vec3 field_now(const DeviceView& device_view) {
  return model::field_of({device_view.now().limited_a}, device_view.config().device.coils).a;
}

protocol::EffectStatus StatusView::effect(const Effect& effect) const {
  protocol::EffectStatus e;
  e.effect = effect.id;
  e.slot = effect.slot;
  e.method = std::string(protocol::name(effect.plan.spec.method));
  e.connection = effect.owner;
  if (!effect.client.empty()) e.client = effect.client;
  e.priority = effect.plan.spec.priority;
  const control::EffectStatus& live = device_view_.now().effects[effect.place];
  if (live.effect == effect.id) {
    e.playing = live.playing;
    e.remaining_ms = live.remaining;
    e.current_a = live.current_a;
  }
  return e;
}

void StatusView::refresh_forecast() {
  const StatusSnapshot& s = device_view_.now();
  if (s.tick - forecast_tick_ < kForecastPeriod) return;
  forecast_tick_ = s.tick;
  if (!device_view_.temperature_known()) {
    headroom_s_ = burst_s_ = 0.0;
    return;
  }
  const model::ForecastStart start = device_view_.forecast_start();
  headroom_s_ = device_view_.forecaster().seconds_to_derating(
      start, model::RequestedCurrents::constant(s.limited_a));
  burst_s_ = device_view_.forecaster().burst_s(start);
}

model::PinMotion StatusView::pins() const {
  const StatusSnapshot& s = device_view_.now();
  // The device file describes a real ball until it is calibrated.
  const config::Config& config = device_view_.config();
  const model::DeviceModel& ball =
      device_view_.simulated() ? config.simulated_ball() : config.device;
  // A silent board has switched the coils off. For the simulated ball the true state is known.
  model::CoilCurrents flowing;
  const device::PlantTruth& truth = device_view_.truth();
  if (s.board_present && device_view_.simulated() && truth.known)
    flowing.a = truth.current_a;
  else if (s.board_present)
    flowing.a = flowing_a(s.board);
  return model::pin_motion(device_view_.array(), device_view_.true_pin_curves(),
                           model::field_of(flowing, ball.coils), ball.force_slope_n_a);
}

protocol::Status StatusView::status(bool with_pins) {
  refresh_forecast();
  const StatusSnapshot& s = device_view_.now();
  const config::Config& config = device_view_.config();
  protocol::Status out;
  out.device = config.device.name;
  out.simulated = device_view_.simulated();
  out.time_ns = device_view_.time_ns(s.tick);
  out.state = std::string(control::name(s.state));
  out.reason = device_view_.reason_now();
  out.since_s = static_cast<double>(s.tick - s.since) * model::kTickSeconds;
  out.remedy = device_view_.remedy_now();
  out.temperature_c =
      temperature(s, config.device.thermal.sensor_winding, device_view_.temperature_known());
  out.limit_a = device_view_.shown_limit_a(s.limit_a);
  out.headroom_s = headroom_s_;
  out.burst_s = burst_s_;
  out.derating = s.derating;
  if (s.board_present) {
    out.current_a = flowing_a(s.board);
    out.duty = s.board.duty;
    out.supply_v = s.board.supply_v;
  }

  const model::Vec3 field = field_now(device_view_);
  const double flowing_a = model::norm(field);
  if (flowing_a > kFlowsA) {
    const model::NearestPin nearest = model::nearest_pin(device_view_.array(), field);
    out.field = (1.0 / flowing_a) * field;
    out.pin = nearest.id;
    out.force_n = device_view_.pin_curves().force_at_rest_n(
        static_cast<std::size_t>(nearest.id),
        config.device.force_slope_n_a * flowing_a * nearest.cosine);
  }
  if (s.board_present) {
    out.fan.speed_rpm = s.board.fan_rpm;
    out.fan.duty = s.board.fan_duty;
    out.fan.cooling = s.fan_cooling;
  }
  if (s.orientation_present) out.orientation = orientation(s);
  for (std::uint8_t place = 0; place < control::kEffectPlaces; ++place)
    if (const Effect* e = effects_.at(place, s.effects[place].effect))
      out.effects.push_back(effect(*e));
  std::sort(out.effects.begin(), out.effects.end(),
            [](const auto& a, const auto& b) { return a.effect < b.effect; });
  out.loop = loop(s.loop);
  out.link = {s.link.frames_out, s.link.lost, s.link.errors};
  out.applied_seq = s.applied_seq;
  if (s.last_trip.reason != control::Reason::kNone) {
    const control::Trip& trip = s.last_trip;
    out.last_trip = protocol::TripStatus{
        std::string(control::name(trip.reason)), device_view_.time_ns(trip.tick),
        finite(trip.temperature_c), trip.current_a, disagreement_view(trip.disagreement)};
  }
  if (with_pins) out.pins = pins();
  return out;
}

}  // namespace hedgehog::server
