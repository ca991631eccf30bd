// SPDX-License-Identifier: MIT
#include "daemon/server/device/device_view.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "daemon/control/checks/board_check.h"
#include "model/limit/rearm.h"
#include "model/thermal/fan.h"

namespace hedgehog::server {
namespace {

/// A simulated sensor reports 100 times a second.
constexpr model::Tick kSimulatedImuPeriod = 10;

}  // namespace

DeviceView::DeviceView(const config::Config& config, control::Mailbox& mailbox,
                       device::LinkPort& link, std::int64_t epoch_ns)
    : config_(config),
      mailbox_(mailbox),
      link_(link),
      epoch_ns_(epoch_ns),
      pins_(std::async(std::launch::async, pins_of, config.device.geometry,
                       simulated() ? config.simulated_ball().geometry : config.device.geometry)),
      forecaster_(config.device.coils, config.device.thermal, config.limits),
      outbox_(mailbox) {
  link_.limits.write(device::BoardLimits::of(config.limits));
  simulator_.ambient_c = config.simulator.ambient_c;
  if (config.imu == config::ImuType::kSimulator) set_orientation({});
  set_snapshot(mailbox_.status.read());
}

DeviceView::Pins DeviceView::pins_of(const model::BallGeometry& ball,
                                     const model::BallGeometry& true_ball) {
  auto pins = model::ball_pins(ball).value();
  auto true_pins = ball == true_ball ? pins : model::ball_pins(true_ball).value();
  const double pitch_deg = model::pin_pitch_deg(pins->array);
  return {std::move(pins), std::move(true_pins), pitch_deg};
}

void DeviceView::refresh() {
  const control::StatusSnapshot& latest = mailbox_.status.read();
  if (mailbox_.status.was_fresh()) set_snapshot(latest);
}

void DeviceView::set_snapshot(const control::StatusSnapshot& latest) {
  const model::Tick before = snapshot_.tick;
  snapshot_ = latest;
  outbox_.set_applied(snapshot_.applied_seq);
  const double seconds = static_cast<double>(snapshot_.tick - before) * model::kTickSeconds;
  mean_current_a_ += (model::norm(snapshot_.limited_a) - mean_current_a_) *
                     std::clamp(seconds / model::Fan::kMeanS, 0.0, 1.0);
  renew_orientation();
}

std::optional<std::uint64_t> DeviceView::request_gain(ConnectionId owner, double gain) {
  const auto seq = outbox_.add(owner, control::SetGain{gain});
  if (seq) {
    requested_gain_ = gain;
    gain_seq_ = *seq;
  }
  return seq;
}

void DeviceView::set_config(const config::Config& config) {
  if (!(config.limits == config_.limits))
    link_.limits.write(device::BoardLimits::of(config.limits));
  config_ = config;
  forecaster_ = model::Forecaster(config.device.coils, config.device.thermal, config.limits);
}

model::ForecastStart DeviceView::forecast_start() const noexcept {
  model::ForecastStart start;
  start.nodes = snapshot_.thermal.nodes;
  const double above_k = snapshot_.thermal.hottest_c - model::hottest_winding(start.nodes);
  start.above_k = std::isfinite(above_k) ? std::max(0.0, above_k) : 0.0;
  start.skin = snapshot_.skin.estimate;
  start.skin_above_k = snapshot_.skin.above_k;
  start.ambient_c = snapshot_.thermal.ambient_c;
  start.fan_running = snapshot_.fan_cooling;
  start.fan_works = snapshot_.reason != control::Reason::kFanStopped && snapshot_.fan_works;
  start.mean_current_a = mean_current_a_;
  return start;
}

std::optional<double> DeviceView::cold_burst_s() const noexcept {
  const model::ForecastStart now = forecast_start();
  model::ForecastStart cold;
  cold.ambient_c = now.ambient_c;
  cold.nodes.winding_c.fill(now.ambient_c);
  cold.nodes.core_c = now.ambient_c;
  cold.above_k = now.above_k;
  cold.skin = model::SkinEstimate(config_.device.thermal);
  cold.skin_above_k = now.skin.margin_k();
  return forecaster_.burst_s(cold);
}

bool DeviceView::is_board_limited() const noexcept {
  return !(control::limits_within(config_.limits, snapshot_.board) == config_.limits);
}

std::optional<MeasuredR25> DeviceView::r25(int coil) const noexcept {
  const auto i = static_cast<std::size_t>(coil);
  MeasuredR25 r25;
  r25.ohm = snapshot_.r25_ohm[i];
  if (!(r25.ohm > 0.0)) return std::nullopt;
  r25.file_ohm = config_.device.coils.r25_ohm[i];
  r25.from_file = r25.ohm / r25.file_ohm - 1.0;
  if (saved_r25_ohm_[i] > 0.0) {
    r25.kept_ohm = saved_r25_ohm_[i];
    r25.from_kept = r25.ohm / saved_r25_ohm_[i] - 1.0;
  }
  return r25;
}

bool DeviceView::temperature_known() const noexcept {
  return std::isfinite(snapshot_.thermal.hottest_c);
}

double DeviceView::hottest_c() const noexcept {
  return model::hottest_winding(snapshot_.thermal.nodes);
}

RemedyFacts DeviceView::remedy_facts() const {
  return {model::rearm_below_c(config_.limits, snapshot_.thermal.ambient_c),
          simulated(),
          board().problem,
          static_cast<double>(snapshot_.rearm_wait) * model::kTickSeconds,
          snapshot_.rearms[static_cast<std::size_t>(snapshot_.latch)],
          snapshot_.last_trip.disagreement.any()};
}

std::optional<std::string> DeviceView::board_protocol() const {
  if (!snapshot_.board_present) return std::nullopt;
  return std::to_string(snapshot_.board.protocol_version) + "." +
         std::to_string(snapshot_.board.protocol_minor);
}

double DeviceView::shown_limit_a(double allowed_a) const noexcept {
  return std::min(std::round(100.0 * allowed_a) / 100.0, limits().current_a);
}

bool DeviceView::too_hot() const noexcept {
  return snapshot_.state == control::State::kArmed && temperature_known() &&
         snapshot_.limit_a < limits().felt_a;
}

std::optional<std::string> DeviceView::reason_now() const {
  return too_hot() ? "too_hot" : reason_name(snapshot_.reason);
}

std::optional<std::string> DeviceView::remedy_now() const {
  if (too_hot())
    return too_hot_remedy(snapshot_.thermal.hottest_c, snapshot_.skin.bound_c, limits());
  return remedy(snapshot_.state, snapshot_.reason, remedy_facts());
}

void DeviceView::set_orientation(const model::Quaternion& quaternion) {
  orientation_.present = true;
  orientation_.quaternion = quaternion;
  orientation_.rate_deg_s = {};
  orientation_.stamp = snapshot_.tick;
  mailbox_.orientation.write(orientation_);
}

void DeviceView::set_simulator(const device::SimulatorSettings& settings) {
  simulator_ = settings;
  link_.simulator.write(settings);
}

void DeviceView::renew_orientation() {
  if (config_.imu == config::ImuType::kSimulator &&
      snapshot_.tick - orientation_.stamp >= kSimulatedImuPeriod)
    set_orientation(orientation_.quaternion);
}

}  // namespace hedgehog::server
