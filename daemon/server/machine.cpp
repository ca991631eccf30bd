// SPDX-License-Identifier: MIT
#include "daemon/server/machine.h"

#include <algorithm>

#include "daemon/control/board_check.h"
#include "model/rearm.h"

namespace hedgehog::server {
namespace {

/// A simulated sensor reports 100 times a second.
constexpr model::Tick kSimulatedImuPeriod = 10;

}  // namespace

Machine::Machine(const config::Config& config, control::Mailbox& mailbox, device::LinkPort& link,
                 std::int64_t epoch_ns)
    : config_(config),
      mailbox_(mailbox),
      link_(link),
      epoch_ns_(epoch_ns),
      array_(model::hedgehog_86()),
      pin_curves_(model::hedgehog_86_curves()),
      forecaster_(config.device.coils, config.device.thermal, config.limits),
      outbox_(mailbox) {
  link_.limits.write(device::BoardLimits::of(config.limits));
  simulator_.ambient_c = config.simulator.ambient_c;
  if (config.imu == config::ImuType::kSimulator) {
    set_orientation({});
  }
  refresh();
}

void Machine::refresh() {
  const model::Tick before = snapshot_.tick;
  snapshot_ = mailbox_.status.read();
  const double seconds = static_cast<double>(snapshot_.tick - before) * model::kTickSeconds;
  mean_current_a_ += (model::norm(snapshot_.limited_a) - mean_current_a_) *
                     std::clamp(seconds / model::kFanMeanS, 0.0, 1.0);
  keep_orientation_fresh();
}

std::optional<std::uint64_t> Machine::ask_gain(ConnectionId owner, double gain) {
  const auto seq = outbox_.add(owner, control::SetGain{gain});
  if (seq) {
    asked_gain_ = gain;
    gain_seq_ = *seq;
  }
  return seq;
}

void Machine::set_config(const config::Config& config) {
  if (!(config.limits == config_.limits)) {
    link_.limits.write(device::BoardLimits::of(config.limits));
  }
  config_ = config;
  forecaster_ = model::Forecaster(config.device.coils, config.device.thermal, config.limits);
}

model::ForecastStart Machine::forecast_start() const noexcept {
  model::ForecastStart start;
  start.nodes = snapshot_.thermal.nodes;
  start.room_c = snapshot_.thermal.room_c;
  start.fan_running = snapshot_.board.fan_duty > 0.0;
  start.fan_works = snapshot_.reason != control::Reason::kFanStopped;
  start.mean_current_a = mean_current_a_;
  return start;
}

bool Machine::skin_reduces(double current_a) const noexcept {
  return config_.thermometer.role == device::ThermometerRole::kShell &&
         current_a > snapshot_.limit_a + kRoundingA;
}

bool Machine::board_holds_back() const noexcept {
  return !(control::limits_within(config_.limits, snapshot_.board) == config_.limits);
}

RemedyFacts Machine::remedy_facts() const {
  return {model::rearm_below_c(config_.limits, snapshot_.thermal.room_c), simulated(),
          board().trouble};
}

std::optional<std::string> Machine::remedy_now() const {
  return remedy(snapshot_.state, snapshot_.reason, remedy_facts());
}

void Machine::set_orientation(const model::Quaternion& quaternion) {
  orientation_.present = true;
  orientation_.quaternion = quaternion;
  orientation_.rate_deg_s = {};
  orientation_.stamp = snapshot_.tick;
  mailbox_.orientation.write(orientation_);
}

void Machine::set_simulator(const device::SimulatorSettings& settings) {
  simulator_ = settings;
  link_.simulator.write(settings);
}

void Machine::keep_orientation_fresh() {
  if (config_.imu == config::ImuType::kSimulator &&
      snapshot_.tick - orientation_.stamp >= kSimulatedImuPeriod) {
    set_orientation(orientation_.quaternion);
  }
}

}  // namespace hedgehog::server
