// SPDX-License-Identifier: MIT
#include "daemon/server/history/telemetry_samples.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <optional>
#include <span>
#include <type_traits>

#include "base/crc32.h"
#include "daemon/device/board_io.h"
#include "model/vec3.h"

namespace hedgehog::server {
namespace {

constexpr float kUnknown = std::numeric_limits<float>::quiet_NaN();
constexpr std::array<char, 8> kMagic{'H', 'H', 'T', 'E', 'L', 'E', '0', '1'};
/// Smaller currents are measurement noise.
constexpr double kFlowsA = 0.2;

float known(const std::optional<double>& value) {
  return value ? static_cast<float>(*value) : kUnknown;
}

std::optional<double> shown(float value) {
  return std::isfinite(value) ? std::optional<double>(value) : std::nullopt;
}

/// Rounded down to the two reported decimals, so that a reported limit is not above the configured
/// one. The float of a number with two decimals may be slightly below it.
double rounded_down(double ampere) {
  constexpr double kFloatError = 1e-3;
  return std::floor(100.0 * ampere + kFloatError) / 100.0;
}

std::array<float, 3> parts(const model::Vec3& v) {
  return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}

std::uint32_t check_sum(std::string_view bytes) {
  return base::crc32(std::as_bytes(std::span(bytes)));
}

}  // namespace

struct TelemetrySamples::FileHead {
  std::array<char, 8> magic = kMagic;
  std::int64_t unix_ms = 0;
  std::int64_t tick = 0;
  std::uint32_t count = 0;
  std::uint32_t crc = 0;
};

void TelemetrySamples::watch(const control::StatusSnapshot& now) noexcept {
  if (now.board_present) peak_a_ = std::max(peak_a_, std::sqrt(now.totals.peak_a2));
}

void TelemetrySamples::add(const control::StatusSnapshot& now, const protocol::Status& status) {
  const double seconds = static_cast<double>(now.tick - last_tick_) * model::kTickSeconds;
  const double heat = now.totals.heat_a2s - totals_.heat_a2s;
  Sample sample;
  sample.tick = now.tick;
  const protocol::TemperatureStatus& t = status.temperature_c;
  sample.coils_c.fill(kUnknown);
  if (t.model)
    for (std::size_t i = 0; i < sample.coils_c.size(); ++i)
      sample.coils_c[i] = static_cast<float>(t.coils[i]);
  sample.upper_c = known(t.upper);
  sample.sensor_c = known(t.sensor);
  sample.current_a = static_cast<float>(std::sqrt(std::max(0.0, heat / seconds)));
  sample.peak_a = static_cast<float>(peak_a_);
  sample.limit_a = static_cast<float>(status.limit_a);
  sample.duty = parts((1.0 / seconds) * (now.totals.on_s - totals_.on_s));
  sample.headroom_s = known(status.headroom_s);
  changed_ = changed_ || peak_a_ > kFlowsA;
  push(sample);
  totals_ = now.totals;
  last_tick_ = now.tick;
  peak_a_ = 0.0;
}

void TelemetrySamples::push(const Sample& sample) {
  if (samples_.size() < kMaxSamples) {
    samples_.push_back(sample);
    return;
  }
  samples_[next_] = sample;
  next_ = (next_ + 1) % kMaxSamples;
}

const TelemetrySamples::Sample& TelemetrySamples::at(std::size_t age) const noexcept {
  return samples_[(next_ + samples_.size() - 1 - age) % samples_.size()];
}

protocol::TelemetrySample TelemetrySamples::merged(const std::vector<Sample>& samples,
                                                   model::Tick now) {
  const Sample& last = samples.back();
  protocol::TelemetrySample out;
  out.age_s = static_cast<double>(now - last.tick) * model::kTickSeconds;
  if (std::isfinite(last.coils_c[0]))
    out.coils_c.emplace(std::array<double, 3>{last.coils_c[0], last.coils_c[1], last.coils_c[2]});
  out.upper_c = shown(last.upper_c);
  out.sensor_c = shown(last.sensor_c);
  out.limit_a = last.limit_a;
  double squares = 0.0;
  for (const Sample& one : samples) {
    squares += double{one.current_a} * double{one.current_a};
    out.peak_a = std::max(out.peak_a, double{one.peak_a});
    out.limit_a = std::min(out.limit_a, double{one.limit_a});
    for (std::size_t i = 0; i < out.duty.size(); ++i)
      out.duty[i] += double{one.duty[i]} / static_cast<double>(samples.size());
    if (std::isfinite(one.headroom_s))
      out.headroom_s = std::min(out.headroom_s.value_or(one.headroom_s), double{one.headroom_s});
  }
  out.current_a = std::sqrt(squares / static_cast<double>(samples.size()));
  out.limit_a = rounded_down(out.limit_a);
  return out;
}

protocol::TelemetryHistoryResult TelemetrySamples::recent(double seconds, model::Tick now,
                                                          std::int64_t time_ns) const {
  const auto max_age = static_cast<model::Tick>(seconds / model::kTickSeconds);
  const auto wanted = static_cast<std::size_t>(std::ceil(seconds));
  const auto max_samples = static_cast<std::size_t>(protocol::TelemetryHistoryResult::kMaxSamples);
  const std::size_t each = (wanted + max_samples - 1) / max_samples;
  protocol::TelemetryHistoryResult out;
  out.time_ns = time_ns;
  out.step_s = static_cast<double>(each) * static_cast<double>(kPeriod) * model::kTickSeconds;
  std::size_t count = 0;
  while (count < samples_.size() && now - at(count).tick < max_age) ++count;
  std::vector<Sample> step;
  const auto end_step = [&] {
    if (!step.empty()) out.samples.push_back(merged(step, now));
    step.clear();
  };
  for (std::size_t age = count; age-- > 0;) {
    const Sample& sample = at(age);
    // A gap also ends a step.
    if (!step.empty() && sample.tick - step.back().tick > 2 * kPeriod) end_step();
    step.push_back(sample);
    if (step.size() == each) end_step();
  }
  end_step();
  // Gaps increase the number of steps; the oldest are dropped.
  if (out.samples.size() > max_samples) {
    const auto excess = static_cast<std::ptrdiff_t>(out.samples.size() - max_samples);
    out.samples.erase(out.samples.begin(), out.samples.begin() + excess);
  }
  return out;
}

std::string TelemetrySamples::encoded(model::Tick now, std::int64_t unix_ms) const {
  static_assert(std::is_trivially_copyable_v<Sample> && sizeof(Sample) == 56);
  std::string body;
  body.reserve(samples_.size() * sizeof(Sample));
  for (std::size_t age = samples_.size(); age-- > 0;)
    body.append(reinterpret_cast<const char*>(&at(age)), sizeof(Sample));
  FileHead head;
  head.unix_ms = unix_ms;
  head.tick = now;
  head.count = static_cast<std::uint32_t>(samples_.size());
  head.crc = check_sum(body);
  return std::string(reinterpret_cast<const char*>(&head), sizeof head) + body;
}

void TelemetrySamples::restore(std::string_view bytes, model::Tick now, std::int64_t unix_ms) {
  static_assert(std::is_trivially_copyable_v<FileHead> && sizeof(FileHead) == 32);
  FileHead head;
  if (bytes.size() < sizeof head) return;
  std::memcpy(&head, bytes.data(), sizeof head);
  bytes.remove_prefix(sizeof head);
  const bool whole = head.magic == kMagic && head.count <= kMaxSamples &&
                     bytes.size() == head.count * sizeof(Sample) && check_sum(bytes) == head.crc;
  constexpr auto kMaxGapMs = static_cast<std::int64_t>(kMaxSamples) * kPeriod;
  const std::int64_t gap_ms = unix_ms - head.unix_ms;
  if (!whole || gap_ms < 0 || gap_ms > kMaxGapMs) return;
  for (std::size_t i = 0; i < head.count; ++i) {
    Sample sample;
    std::memcpy(&sample, bytes.data() + i * sizeof sample, sizeof sample);
    const model::Tick age = head.tick - sample.tick;
    if (age < 0 || age > 2 * kMaxGapMs) continue;
    sample.tick = now - age - gap_ms;
    push(sample);
  }
}

}  // namespace hedgehog::server
