// SPDX-License-Identifier: MIT
#include "clients/ctl/calibrate/heat_bench.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "clients/ctl/calibrate/armed_status.h"

namespace hedgehog::client {
namespace {

constexpr std::int64_t kHeatLeaseMs = 8000;
constexpr std::int64_t kHeatClaimMs = 10'000;
/// Below this speed a fan cools no better than a stopped one; same value as in the daemon.
constexpr double kMinFanRpm = 300.0;
/// Six standard deviations of the noise of one current, A.
constexpr double kSettledA = 0.3;
/// A longer interval between telemetry messages is a gap, s.
constexpr double kMaxGapS = 1.0;

bool alike(const model::Vec3& a, const model::Vec3& b) { return model::norm(a - b) < kSettledA; }

}  // namespace

model::HeatSample mean_of(const std::vector<HeatReading>& readings, double from_s) {
  model::HeatSample sample;
  sample.end_s = readings.back().t_s;
  sample.dt_s = sample.end_s - from_s;
  std::size_t settled = readings.size();
  while (settled > 0 && alike(readings[settled - 1].current_a, readings.back().current_a))
    --settled;
  // The first of them may still have been changing.
  ++settled;
  sample.count = static_cast<int>(readings.size()) - static_cast<int>(settled);
  for (std::size_t k = 0; k < readings.size(); ++k) {
    const HeatReading& one = readings[k];
    for (std::size_t i = 0; i < 3; ++i) {
      const auto axis = static_cast<int>(i);
      sample.power_w[i] +=
          one.voltage_v[axis] * one.current_a[axis] / static_cast<double>(readings.size());
      if (k < settled) continue;
      sample.voltage_v[i] += one.voltage_v[axis] / sample.count;
      sample.current_a[i] += one.current_a[axis] / sample.count;
    }
  }
  return sample;
}

Outcome<protocol::Status> HeatBench::next() {
  auto status = next_status(session_);
  if (status && status->state != "armed") return not_armed(*status);
  return status;
}

HeatBench::HeatBench(Session& session, const protocol::CoilsDescription& coils)
    : session_(session) {
  model::Mat3 matrix;
  for (std::size_t row = 0; row < coils.matrix.size(); ++row) matrix.row[row] = coils.matrix[row];
  to_demand_ = model::inverse(matrix);
}

Outcome<void> HeatBench::begin() {
  if (auto claimed = session_.connection.call(protocol::DeviceClaim{kHeatClaimMs}); !claimed)
    return claimed.error();
  using protocol::StatusKey;
  if (auto subscribed = subscribe(session_, kHeatTelemetryHz,
                                  {StatusKey::kTemperatureC, StatusKey::kCurrentA, StatusKey::kDuty,
                                   StatusKey::kSupplyV, StatusKey::kFan});
      !subscribed)
    return subscribed.error();
  now_s_ = -1.0;
  return {};
}

Outcome<void> HeatBench::end() {
  if (auto done = session_.connection.call(protocol::EffectStopAll{}); !done) return done.error();
  if (auto done = session_.connection.call(protocol::TelemetryUnsubscribe{}); !done)
    return done.error();
  return {};
}

Outcome<void> HeatBench::drive(const model::HeatingStep& step) {
  if (auto claimed = session_.connection.call(protocol::DeviceClaim{kHeatClaimMs}); !claimed)
    return claimed.error();
  // The coil frame limits the demand to the continuous current.
  const model::Vec3 demand = to_demand_ * step.current_a;
  const double demand_a = model::norm(demand);
  if (demand_a == 0.0) {
    if (auto done = session_.connection.call(protocol::EffectStopAll{}); !done) return done.error();
    return {};
  }
  protocol::EffectParams params;
  params.direction = (1.0 / demand_a) * demand;
  params.current_a = demand_a;
  params.waveform = model::Waveform::kConstant;
  params.slot = "heat";
  params.lease_ms = kHeatLeaseMs;
  const protocol::EffectStart constant{model::EffectMethod::kVibrate, params};
  if (auto begun = session_.connection.call(constant); !begun) return begun.error();
  return {};
}

Outcome<model::HeatSample> HeatBench::run(const model::HeatingStep& step) {
  if (auto driven = drive(step); !driven) return driven.error();
  std::vector<HeatReading> readings;
  protocol::Status last;
  double from_s = now_s_;
  double sensor_sum_c = 0.0;
  int sensor_count = 0;
  while (readings.empty() || now_s_ < from_s + step.duration_s) {
    auto status = next();
    if (!status) return status.error();
    last = *std::move(status);
    const double t_s = 1e-9 * static_cast<double>(last.time_ns);
    if (now_s_ < 0.0) from_s = now_s_ = t_s;
    if (t_s > now_s_ + kMaxGapS) {
      return ClientError{Failure::kTimeout,
                         "telemetry stopped for a second: reduce the load of this computer",
                         {}};
    }
    now_s_ = t_s;
    if (!last.supply_v) return measuring_failed("the daemon does not report the supply voltage");
    readings.push_back({t_s, *last.supply_v * last.duty, last.current_a});
    if (last.temperature_c.sensor) {
      sensor_sum_c += *last.temperature_c.sensor;
      ++sensor_count;
    }
  }
  model::HeatSample sample = mean_of(readings, from_s);
  sample.fan_running = last.fan.speed_rpm.value_or(0.0) > kMinFanRpm;
  if (sensor_count > 0) sample.sensor_c = sensor_sum_c / sensor_count;
  return sample;
}

}  // namespace hedgehog::client
