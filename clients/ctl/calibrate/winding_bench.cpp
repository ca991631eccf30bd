// SPDX-License-Identifier: MIT
#include "clients/ctl/calibrate/winding_bench.h"

#include <cmath>

#include "clients/ctl/calibrate/armed_status.h"

namespace hedgehog::client {
namespace {

using model::EffectMethod;
using protocol::EffectParams;

constexpr double kTelemetryHz = 200.0;
constexpr double kWaitingHz = 5.0;
constexpr double kSettleS = 0.2;
/// Maximum duration of a measured current; it is stopped earlier.
constexpr std::int64_t kFlowsMs = 10'000;
constexpr std::int64_t kPushMs = 700;

EffectParams along(int coil, double sign, double current_a) {
  EffectParams params;
  model::Vec3 direction{};
  direction[coil] = sign;
  params.direction = direction;
  params.frame = model::Frame::kCoil;
  params.current_a = current_a;
  params.if_limited = protocol::IfLimited::kRefuse;
  return params;
}

}  // namespace

Outcome<protocol::Status> WindingBench::next() {
  auto status = next_status(session_);
  if (!status || status->state == "armed") return status;
  if (status->state == "tripped") tripped_ = status->reason.value_or("");
  return not_armed(*status);
}

Outcome<double> WindingBench::start(EffectMethod method, const EffectParams& params) {
  const auto before = session_.connection.call(protocol::Ping{});
  if (!before) return before.error();
  if (auto begun = play(method, params); !begun) return begun.error();
  using protocol::StatusKey;
  // Only now, so that no sample precedes the effect.
  if (auto subscribed = subscribe(session_, kTelemetryHz,
                                  {StatusKey::kCurrentA, StatusKey::kDuty, StatusKey::kSupplyV});
      !subscribed)
    return subscribed.error();
  return 1e-9 * static_cast<double>(before->time_ns) + 1e-3 * static_cast<double>(kFlowsMs);
}

Outcome<void> WindingBench::play(EffectMethod method, const EffectParams& params) {
  // No other client can play meanwhile; the claim ends with the connection.
  if (auto claimed = session_.connection.call(protocol::DeviceClaim{}); !claimed)
    return claimed.error();
  if (auto begun = session_.connection.call(protocol::EffectStart{method, params}); !begun)
    return begun.error();
  return {};
}

Outcome<void> WindingBench::stop() {
  if (auto done = session_.connection.call(protocol::EffectStopAll{}); !done) return done.error();
  if (auto done = session_.connection.call(protocol::TelemetryUnsubscribe{}); !done)
    return done.error();
  // Discards what was received before.
  for (;;) {
    auto notification = session_.connection.next(Milliseconds(0));
    if (!notification) return notification.error();
    if (!*notification) return {};
  }
}

Outcome<WindingRecord> WindingBench::record(int coil, Extent extent, const ErrorOf& error_of,
                                            double flows_until_s) {
  WindingRecord record;
  std::optional<double> began;
  for (;;) {
    const auto status = next();
    if (!status) return status.error();
    const double t_s = static_cast<double>(status->time_ns) * 1e-9;
    began = began.value_or(t_s);
    if (t_s < *began + kSettleS) continue;
    const bool enough = record.samples.size() >= kMinSamples;
    if (enough && t_s > *began + kSettleS + extent.take_s &&
        !(error_of(record.samples) > extent.max_error))
      break;
    if (t_s > flows_until_s) {
      if (enough) break;
      return ClientError{Failure::kTimeout,
                         "telemetry rate too low to measure a winding: reduce the load of this "
                         "computer or the network, then calibrate again",
                         {}};
    }
    if (!status->supply_v) return measuring_failed("the daemon does not report the supply voltage");
    record.supply_v = *status->supply_v;
    record.samples.push_back(
        {t_s, status->current_a[coil], status->duty[coil] * *status->supply_v});
    for (int any = 0; any < 3; ++any)
      record.mean_a[static_cast<std::size_t>(any)] += status->current_a[any];
  }
  for (double& mean : record.mean_a) mean /= static_cast<double>(record.samples.size());
  if (auto stopped = stop(); !stopped) return stopped.error();
  return record;
}

Outcome<void> WindingBench::wait_until(double t_s) {
  if (auto subscribed = subscribe(session_, kWaitingHz, {}); !subscribed) return subscribed.error();
  for (;;) {
    const auto status = next();
    if (!status) return status.error();
    if (1e-9 * static_cast<double>(status->time_ns) >= t_s) return stop();
  }
}

Outcome<protocol::Status> WindingBench::rest() {
  const auto status = session_.connection.call(protocol::DeviceStatus{});
  if (!status) return status.error();
  if (status->state != "armed") return not_armed(*status);
  if (!status->temperature_c.sensor)
    return measuring_failed("the coil thermometer does not answer");
  return *status;
}

Outcome<WindingRecord> WindingBench::hold(int coil, double sign, double current_a, Extent extent) {
  EffectParams params = along(coil, sign, current_a);
  params.lease_ms = kFlowsMs;
  const auto flows_until_s = start(EffectMethod::kHold, params);
  if (!flows_until_s) return flows_until_s.error();
  return record(coil, extent, mean_error, *flows_until_s);
}

Outcome<WindingRecord> WindingBench::sine(int coil, double current_a, double frequency_hz,
                                          Extent extent) {
  EffectParams params = along(coil, 1.0, current_a);
  params.waveform = model::Waveform::kSine;
  params.frequency_hz = frequency_hz;
  params.duration_ms = kFlowsMs;
  const auto flows_until_s = start(EffectMethod::kVibrate, params);
  if (!flows_until_s) return flows_until_s.error();
  const auto error_of = [frequency_hz](const std::vector<WindingSample>& samples) {
    return inductance_error(samples, frequency_hz);
  };
  return record(coil, extent, error_of, *flows_until_s);
}

Outcome<void> WindingBench::push(int coil, double current_a) {
  EffectParams params = along(coil, 1.0, current_a);
  params.duration_ms = kPushMs;
  params.slot = "push";
  return play(EffectMethod::kPulse, params);
}

}  // namespace hedgehog::client
