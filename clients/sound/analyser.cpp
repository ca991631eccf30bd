// SPDX-License-Identifier: MIT
#include "clients/sound/analyser.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace hedgehog::sound {

namespace {

constexpr double kSteadyHz = 15.0;
constexpr double kRise = 4.0;
constexpr double kFloorPower = 1e-5;
constexpr std::int64_t kHopsApart = 12;
constexpr std::int64_t kHopsToPeak = 3;

}  // namespace

SoundAnalyser::Side::Side(double rate_hz, double low_hz)
    : low(Biquad::Kind::kLowPass, low_hz, rate_hz),
      high(Biquad::Kind::kHighPass, low_hz, rate_hz),
      steady(Biquad::Kind::kHighPass, kSteadyHz, rate_hz, std::numbers::sqrt2 / 2.0) {}

SoundAnalyser::SoundAnalyser(double rate_hz, double low_hz)
    : rate_hz_(rate_hz),
      sides_{Side(rate_hz, low_hz), Side(rate_hz, low_hz)},
      last_onset_hop_(-kHopsApart) {}

void SoundAnalyser::take_sample(Side& side, double value) {
  const double low = side.steady.next(side.low.next(value));
  side.low_power += low * low;
  if (side.last_low < 0.0 && low >= 0.0) ++side.periods;
  side.last_low = low;
  const double high = std::abs(side.high.next(value));
  side.high_power += high * high;
  side.high_peak = std::max(side.high_peak, high);
}

void SoundAnalyser::add(std::span<const StereoSample> samples) {
  for (const StereoSample& sample : samples) {
    take_sample(sides_[0], sample.left);
    take_sample(sides_[1], sample.right);
    hop_.push_back({sides_[0].high_peak, sides_[1].high_peak});
    ++samples_;
    ++window_samples_;
    const auto end = static_cast<std::int64_t>(static_cast<double>(hops_ + 1) * rate_hz_ /
                                               static_cast<double>(kHopsPerSecond));
    if (samples_ >= end) end_hop();
  }
}

void SoundAnalyser::end_hop() {
  const auto count = static_cast<double>(hop_.size());
  find_onset(std::max(sides_[0].high_power, sides_[1].high_power) / count);
  ++hops_;
  hop_.clear();
  for (Side& side : sides_) side.high_power = side.high_peak = 0.0;
  if (hops_ % kHopsPerWindow == 0) end_window();
}

void SoundAnalyser::find_onset(double power) {
  const bool begins = power > kFloorPower && hops_ - last_onset_hop_ >= kHopsApart &&
                      power > kRise * *std::max_element(before_.begin(), before_.end());
  std::rotate(before_.begin(), before_.begin() + 1, before_.end());
  before_.back() = power;
  if (begins) {
    // Within the hop the onset is where half of the peak is reached.
    const double half = 0.5 * std::max(hop_.back()[0], hop_.back()[1]);
    const auto first = std::find_if(hop_.begin(), hop_.end(), [half](const auto& peaks) {
      return std::max(peaks[0], peaks[1]) >= half;
    });
    const double sample = static_cast<double>(samples_) - static_cast<double>(hop_.end() - first);
    growing_ = {1000.0 * sample / rate_hz_, 0.0, 0.0};
    last_onset_hop_ = hops_;
    is_growing_ = true;
  }
  if (!is_growing_) return;
  growing_.left = std::max(growing_.left, sides_[0].high_peak);
  growing_.right = std::max(growing_.right, sides_[1].high_peak);
  if (hops_ - last_onset_hop_ + 1 < kHopsToPeak) return;
  onsets_.push_back(growing_);
  is_growing_ = false;
}

void SoundAnalyser::end_window() {
  const auto amplitude = [this](const Side& side) {
    return std::min(1.0, std::sqrt(2.0 * side.low_power / static_cast<double>(window_samples_)));
  };
  const Side& louder = sides_[0].low_power >= sides_[1].low_power ? sides_[0] : sides_[1];
  windows_.push_back({amplitude(sides_[0]), amplitude(sides_[1]), louder.periods});
  window_samples_ = 0;
  for (Side& side : sides_) {
    side.low_power = 0.0;
    side.periods = 0;
  }
}

void SoundAnalyser::finish() {
  const StereoSample silence{};
  while (!hop_.empty() || hops_ % kHopsPerWindow != 0 || is_growing_) add({&silence, 1});
}

std::vector<Onset> SoundAnalyser::take_onsets() { return std::exchange(onsets_, {}); }
std::vector<LowWindow> SoundAnalyser::take_windows() { return std::exchange(windows_, {}); }

double SoundAnalyser::found_until_ms() const noexcept {
  const std::int64_t hop = is_growing_ ? last_onset_hop_ : hops_;
  return 1000.0 * static_cast<double>(hop) / static_cast<double>(kHopsPerSecond);
}

}  // namespace hedgehog::sound
