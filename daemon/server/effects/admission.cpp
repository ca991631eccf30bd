// SPDX-License-Identifier: MIT
#include "daemon/server/effects/admission.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace hedgehog::server {
namespace {

bool sounds(const DeviceView& device_view, const Effect& e) {
  const control::EffectStatus& live = device_view.now().effects[e.place];
  if (live.effect == e.id) return live.playing;
  if (device_view.now().applied_seq >= e.seq)
    return false;  // ended by itself; its event has not been read yet
  // Not applied yet; one whose connection has closed is ended at once.
  return e.owner != 0 && e.plan.spec.delay == 0 && e.plan.spec.start_at <= device_view.now().tick;
}

/// `direction` as in onset_direction.
model::Vec3 winding_direction(const model::EffectSpec& spec, const KeyframeTrack* track,
                              const model::Vec3& direction, const model::CoilModel& coils) {
  if (spec.frame != model::Frame::kCoil) return coils.matrix * direction;
  return track != nullptr ? model::rotate(spec.trajectory.playback.turn, track->peak_direction)
                          : spec.trajectory.direction;
}

/// After a restart without saved heat a winding is limited to continuous_a until it has been
/// measured: returns the remaining share of `current_a`, 0..1.
double unmeasured_share(const DeviceView& device_view, const model::Vec3& current_a) {
  double share = 1.0;
  for (int coil = 0; coil < model::kCoils; ++coil) {
    const double requested_a = std::abs(current_a[coil]);
    if (!device_view.now().thermal.measured[static_cast<std::size_t>(coil)] &&
        requested_a > device_view.limits().continuous_a + kRoundingA)
      share = std::min(share, device_view.limits().continuous_a / requested_a);
  }
  return share;
}

}  // namespace

Felt felt_now(const DeviceView& device_view, EffectRegistry& effects, const Effect* except) {
  Felt felt;
  for (const Effect* e : effects.playing()) {
    const int priority = e->plan.spec.priority;
    if (e == except || priority < felt.priority || !sounds(device_view, *e)) continue;
    const Load load = load_of(e->plan.spec, e->plan.track.get(), device_view.config().device.coils,
                              device_view.now().orientation);
    felt.load = priority > felt.priority ? load : felt.load + load;
    felt.priority = priority;
  }
  return felt;
}

Delivery expected_delivery(const DeviceView& device_view, EffectRegistry& effects,
                           const model::EffectSpec& spec, const KeyframeTrack* track,
                           const Effect* replaced) {
  const control::StatusSnapshot& now = device_view.now();
  const config::Config& config = device_view.config();
  Delivery delivery;
  protocol::Admission& out = delivery.admission;
  const model::Vec3 direction = onset_direction(spec, track, config.device.coils, now.orientation);
  const model::NearestPin nearest = model::nearest_pin(device_view.array(), direction);
  out.pin = nearest.id;
  if (spec.trajectory.path == model::Path::kCircle) {
    out.period_ms = 1000.0 *
                    model::circle_steps(spec.trajectory.ring_deg, spec.trajectory.pitch_deg) /
                    spec.trajectory.speed_pins_s;
  }

  const Felt others = felt_now(device_view, effects, replaced);
  if (others.priority > spec.priority) {
    out.limited_by = "priority";
    return delivery;
  }
  const Load own = load_of(spec, track, config.device.coils, now.orientation);
  const Load requested = others.priority == spec.priority ? others.load + own : own;
  double factor = device_view.gain();
  if (factor < 1.0) out.limited_by = "configuration";
  double flowing_a = requested.peak_a() * factor;
  if (flowing_a > config.limits.current_a + kRoundingA) {
    out.limited_by = "mix";
    factor *= config.limits.current_a / flowing_a;
    flowing_a = config.limits.current_a;
  }
  delivery.forecast_of = scaled(requested, factor).requested();
  const auto limit_by_heat = [&](double share) {
    out.limited_by = "thermal";
    out.headroom_s = 0.0;
    delivery.forecast_of.reset();
    factor *= share;
  };
  if (flowing_a > now.limit_a + kRoundingA) limit_by_heat(std::max(0.0, now.limit_a) / flowing_a);
  const double unmeasured = unmeasured_share(
      device_view, factor * peak_a(spec, track) *
                       winding_direction(spec, track, direction, config.device.coils));
  if (unmeasured < 1.0) limit_by_heat(unmeasured);
  out.current_a = peak_a(spec, track) * factor;
  out.force_n = device_view.pin_curves().force_at_rest_n(
      static_cast<std::size_t>(nearest.id),
      out.current_a * config.device.force_slope_n_a * nearest.cosine);
  return delivery;
}

protocol::Admission with_headroom(const DeviceView& device_view, Delivery delivery) {
  if (delivery.forecast_of) {
    delivery.admission.headroom_s = device_view.forecaster().seconds_to_derating(
        device_view.forecast_start(), *delivery.forecast_of);
  }
  return std::move(delivery.admission);
}

std::optional<protocol::RpcError> thermal_refusal(const DeviceView& device_view,
                                                  const model::EffectSpec& spec,
                                                  const KeyframeTrack* track,
                                                  const protocol::EffectParams& params,
                                                  const protocol::Admission& admitted) {
  if (!admitted.headroom_s) return std::nullopt;
  const double needed_s =
      static_cast<double>(spec.lease > 0 ? spec.lease : spec.duration) * model::kTickSeconds;
  const double requested_a = peak_a(spec, track);
  const bool now = admitted.limited_by == "thermal";
  if (!now && *admitted.headroom_s >= needed_s) return std::nullopt;
  protocol::RpcError e;
  e.code = protocol::ErrorCode::kRefusedThermal;
  const double current_limit = device_view.limits().current_a;
  e.limit_a = now ? admitted.current_a : device_view.now().limit_a;
  if (now) {
    e.message = fmt::format("refused_thermal: {:.1f} A asked, {:.1f} A allowed at {:.1f} °C",
                            requested_a, *e.limit_a, device_view.hottest_c());
    e.field = params.level ? "level" : params.force_n ? "force_n" : "current_a";
    const double per_ampere = params.level     ? 1.0 / current_limit
                              : params.force_n ? device_view.config().device.force_slope_n_a
                                               : 1.0;
    e.limit = *e.limit_a * per_ampere;
    e.value = spec.strength_a * per_ampere;
  } else {
    e.message = fmt::format(
        "refused_thermal: {:.1f} A can flow for {:.1f} s from {:.1f} °C, {:.1f} s asked",
        requested_a, *admitted.headroom_s, device_view.hottest_c(), needed_s);
    e.field = spec.lease > 0 ? "lease_ms" : "duration_ms";
    e.limit = static_cast<std::int64_t>(*admitted.headroom_s * 1000.0);
    e.value = static_cast<std::int64_t>(spec.lease > 0 ? spec.lease : spec.duration);
  }
  const auto recovery_s = device_view.forecaster().recovery_s(device_view.forecast_start());
  if (recovery_s) e.retry_after_ms = static_cast<std::int64_t>(std::ceil(*recovery_s * 1000.0));
  return e;
}

}  // namespace hedgehog::server
