// SPDX-License-Identifier: MIT
#include "clients/sound/slices.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hedgehog::sound {

namespace {

constexpr std::size_t kWindowsPerSlice = kSliceMs / kWindowMs;
/// Amplitudes below -40 dB of full scale are silence.
constexpr double kSilence = 0.01;
constexpr double kMinVibrationHz = 20.0;
constexpr double kMaxVibrationHz = 250.0;
constexpr double kReadSeconds = 0.1;

double louder(double left, double right) { return std::max(left, right); }

protocol::Keyframe keyframe(std::int64_t t_ms, double azimuth, double level, model::Ease ease) {
  // Rounded, to keep messages short.
  return {t_ms, protocol::Angles{std::round(azimuth), 0.0}, std::round(level * 1000.0) / 1000.0,
          ease};
}

}  // namespace

double azimuth_deg(double left, double right) noexcept {
  if (left <= 0.0 && right <= 0.0) return 0.0;
  return 90.0 - 2.0 * std::atan2(right, left) * 180.0 / std::numbers::pi;
}

SliceReader::SliceReader(SoundFile file, const SliceOptions& options)
    : file_(std::move(file)), options_(options), analyser_(file_.rate_hz(), options.low_hz) {}

bool SliceReader::has_enough() const {
  return windows_.size() > kWindowsPerSlice &&
         analyser_.found_until_ms() >= static_cast<double>(start_ms_ + kSliceMs);
}

void SliceReader::read_more() {
  const auto samples = file_.read(static_cast<std::size_t>(kReadSeconds * file_.rate_hz()));
  analyser_.add(samples);
  if (samples.empty()) {
    analyser_.finish();
    ended_ = true;
  }
  for (const LowWindow& window : analyser_.take_windows()) windows_.push_back(window);
  for (const Onset& onset : analyser_.take_onsets()) onsets_.push_back(onset);
}

std::optional<Slice> SliceReader::next() {
  while (!ended_ && !has_enough()) read_more();
  if (windows_.empty() && onsets_.empty()) return std::nullopt;
  Slice slice;
  slice.start_ms = start_ms_;
  add_pulses(slice);
  add_vibration(slice);
  start_ms_ += kSliceMs;
  return slice;
}

double SliceReader::level(double amplitude, double gain) const {
  const double felt_part = std::min(1.0, amplitude * gain);
  return felt_part < kSilence ? 0.0 : options_.felt + (1.0 - options_.felt) * felt_part;
}

void SliceReader::add_pulses(Slice& slice) {
  while (!onsets_.empty() && onsets_.front().t_ms < static_cast<double>(start_ms_ + kSliceMs)) {
    const Onset onset = onsets_.front();
    onsets_.pop_front();
    const double strength = level(louder(onset.left, onset.right), options_.pulses);
    if (strength <= 0.0) continue;
    const std::int64_t t_ms =
        std::max<std::int64_t>(0, std::llround(onset.t_ms - static_cast<double>(start_ms_)));
    const double azimuth = azimuth_deg(onset.left, onset.right);
    slice.pulses.push_back(keyframe(t_ms, azimuth, strength, model::Ease::kStep));
    slice.pulses.push_back(keyframe(t_ms + kPulseMs, azimuth, 0.0, model::Ease::kStep));
  }
}

void SliceReader::add_vibration(Slice& slice) {
  int periods = 0;
  bool felt = false;
  LowWindow before = last_window_;
  for (std::size_t i = 0; i <= kWindowsPerSlice; ++i) {
    const LowWindow window = i < windows_.size() ? windows_[i] : LowWindow{};
    const double left = 0.5 * (before.left + window.left);
    const double right = 0.5 * (before.right + window.right);
    const double strength = level(louder(left, right), options_.vibration);
    // In silence the direction is kept.
    if (strength > 0.0) last_azimuth_deg_ = azimuth_deg(left, right);
    felt = felt || strength > 0.0;
    slice.vibration.push_back(keyframe(static_cast<std::int64_t>(i) * kWindowMs, last_azimuth_deg_,
                                       strength, model::Ease::kLinear));
    if (i < kWindowsPerSlice) {
      periods += window.periods;
      before = window;
    }
  }
  last_window_ = before;
  windows_.erase(windows_.begin(), windows_.begin() + static_cast<std::ptrdiff_t>(std::min(
                                                          kWindowsPerSlice, windows_.size())));
  if (!felt) slice.vibration.clear();
  const double step_hz = 1000.0 / kSliceMs;
  const double max_hz = step_hz * std::floor(std::min(kMaxVibrationHz, options_.low_hz) / step_hz);
  slice.frequency_hz = std::clamp(periods * step_hz, kMinVibrationHz, max_hz);
}

}  // namespace hedgehog::sound
