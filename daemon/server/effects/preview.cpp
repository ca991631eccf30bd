// SPDX-License-Identifier: MIT
#include "daemon/server/effects/preview.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "daemon/control/checks/fan_check.h"
#include "daemon/control/drive.h"
#include "daemon/control/effects/mixer.h"
#include "daemon/device/board_io.h"
#include "model/estimate/skin_estimate.h"
#include "model/estimate/thermal_winding_meter.h"
#include "model/limit/thermal_limiter.h"
#include "model/thermal/fan.h"
#include "model/thermal/plant.h"

namespace hedgehog::server {
namespace {

using model::kTickSeconds;
using model::Tick;
using model::Vec3;
using model::WindingMeter;

/// Smaller reductions are rounding.
constexpr double kWhole = 1.0 - 1e-6;
constexpr double kFullDuty = model::Fan::kFullDuty;
constexpr control::EffectId kOnly = 1;

model::Plant plant_now(const DeviceView& device_view, model::Fan& fan) {
  const control::StatusSnapshot& now = device_view.now();
  const config::Config& config = device_view.config();
  model::Plant plant(model::PlantParameters::of(config.device.coils, config.device.thermal),
                     now.thermal.ambient_c);
  if (now.board.supply_v > 0.0) plant.set_supply(now.board.supply_v);
  // Sets the fan to its present state.
  const model::ForecastStart start = device_view.forecast_start();
  fan.step(now.thermal.nodes.core_c, start.mean_current_a, model::Fan::kMeanS);
  if (start.fan_running) plant.step_thermal({}, 1.0, plant.parameters().fan_spin_up_s);
  plant.set_heat(now.thermal.nodes);
  return plant;
}

}  // namespace

struct Preview::World {
  /// Mean of the values added since the last take().
  class Mean {
   public:
    void add(const Vec3& value) {
      sum_ = sum_ + value;
      ++count_;
    }
    std::array<double, 3> take() {
      const Vec3 mean = (1.0 / static_cast<double>(count_)) * sum_;
      *this = Mean();
      return {mean.x, mean.y, mean.z};
    }
    Tick count() const noexcept { return count_; }

   private:
    Vec3 sum_;
    Tick count_ = 0;
  };

  explicit World(const DeviceView& device_view)
      : gain(device_view.gain()),
        orientation(device_view.now().orientation),
        coils(device_view.config().device.coils),
        thermal(device_view.config().device.thermal),
        limiter(device_view.limits()),
        plant(plant_now(device_view, fan)) {
    const control::StatusSnapshot& now = device_view.now();
    skin = now.skin.estimate;
    skin_above_k = now.skin.above_k;
    estimate.ambient_c = now.thermal.ambient_c;
    estimate.measured = now.thermal.measured;
    above_windings_k = device_view.forecast_start().above_k;
    result.temperature_c = plant.hottest_winding_c();
    result.peak_temperature_c = result.temperature_c;
  }

  /// The limiter's temperature of the hottest winding.
  double bound_c() const noexcept { return plant.hottest_winding_c() + above_windings_k; }

  /// The limiter's temperature of the skin, one tick later.
  double next_skin_c() noexcept {
    const bool fan_running = plant.fan_rpm() > control::FanCheck::kMinRpm;
    skin.step(model::SkinInputs::of(thermal, plant.heat(), plant.ambient_c(), fan_running),
              kTickSeconds);
    return skin.heated_c() + skin_above_k;
  }

  double gain;
  model::Quaternion orientation;
  model::CoilModel coils;
  model::ThermalModel thermal;
  control::Mixer mixer;
  model::ThermalLimiter limiter;
  model::Fan fan;
  model::Plant plant;
  model::ThermalEstimate estimate;
  double above_windings_k = 0.0;
  model::SkinEstimate skin;
  double skin_above_k = 0.0;
  control::EventList events;
  Tick tick = 0;
  Tick end = 0;
  Mean duty;
  Mean current_a;
  double delivered_sum = 0.0;
  protocol::PreviewResult result;
};

Preview::Preview(const DeviceView& device_view, const EffectPlan& plan)
    : world_(std::make_unique<World>(device_view)) {
  World& w = *world_;
  control::StartEffect start{kOnly, 0, 0, 0, plan.spec};
  start.spec.delay = 0;
  start.spec.start_at = -1;
  if (plan.track) {
    start.spec.trajectory.playback.first = 0;
    const auto& frames = plan.track->frames;
    for (std::size_t i = 0; i < control::LoadKeyframes::commands_for(frames.size()); ++i)
      w.mixer.load(control::LoadKeyframes::slice(frames, 0, i));
  }
  w.mixer.start(start, 0, 0, w.events);
  w.end = start.spec.lease > 0 ? start.spec.lease : start.spec.duration;
  w.result.duration_ms = w.end;
  w.result.step_ms =
      (w.end + protocol::PreviewResult::kMaxSteps - 1) / protocol::PreviewResult::kMaxSteps;
}

Preview::~Preview() = default;

void Preview::step() {
  World& w = *world_;
  for (int coil = 0; coil < model::kCoils; ++coil) {
    const auto i = static_cast<std::size_t>(coil);
    w.estimate.resistance_ohm[i] = w.plant.resistance_ohm(coil);
    w.estimate.measured[i] =
        w.estimate.measured[i] || std::abs(w.plant.current_a()[coil]) > WindingMeter::kMinCurrentA;
  }
  w.estimate.nodes = w.plant.heat();
  w.estimate.hottest_c = w.bound_c();

  w.events.clear();
  const control::MixResult mix = w.mixer.mix({w.tick, true, true, w.orientation, w.gain}, w.events);
  const model::CoilCurrents demand = control::demanded_currents(mix, w.coils);
  const model::LimitedCurrents passed =
      control::limit(w.limiter, demand, w.estimate, w.next_skin_c(), kTickSeconds);
  const double share = control::delivered_share(demand, passed);

  const double supply_v = w.plant.parameters().supply_v;
  const device::BoardCommand command =
      control::drive(passed, mix.playing, w.plant.current_a(),
                     {w.estimate.resistance_ohm, w.coils.inductance_h, supply_v});
  model::PlantInputs inputs;
  inputs.bridge.fill(command.enable() ? model::BridgeState::kDriven : model::BridgeState::kAsleep);
  inputs.voltage_v = supply_v * command.first_duty();
  inputs.fan_duty =
      w.fan.step(w.estimate.hottest_c, norm(w.plant.current_a()), kTickSeconds) / kFullDuty;
  w.plant.step(inputs, kTickSeconds);

  protocol::PreviewResult& r = w.result;
  r.peak_temperature_c = std::max(r.peak_temperature_c, w.plant.hottest_winding_c());
  r.peak_current_a = std::max(r.peak_current_a, norm(w.plant.current_a()));
  r.delivered.min = std::min(r.delivered.min, share);
  w.delivered_sum += share;
  if (share < kWhole && !r.limited_from_ms) r.limited_from_ms = w.tick;
  w.duty.add(command.first_duty());
  w.current_a.add(w.plant.current_a());
  ++w.tick;
  if (w.duty.count() == r.step_ms || w.tick == w.end) {
    r.duty.push_back(w.duty.take());
    r.current_a.push_back(w.current_a.take());
  }
}

bool Preview::advance(Tick ticks) {
  World& w = *world_;
  for (Tick i = 0; i < ticks && w.tick < w.end; ++i) step();
  return w.tick >= w.end;
}

protocol::PreviewResult Preview::result() const {
  const World& w = *world_;
  protocol::PreviewResult result = w.result;
  result.delivered.mean = w.delivered_sum / static_cast<double>(w.end);
  if (result.limited_from_ms)
    result.limited_by = "thermal";
  else if (w.gain < 1.0)
    result.limited_by = "configuration";
  return result;
}

}  // namespace hedgehog::server
