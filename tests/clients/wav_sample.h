// SPDX-License-Identifier: MIT
// Synthesised sounds as WAV files: 16 bit, two channels.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <numbers>
#include <string>
#include <utility>

namespace hedgehog::client {

inline constexpr int kWavRateHz = 48'000;

inline void append_little(std::string& bytes, std::uint32_t value, int count) {
  for (int i = 0; i < count; ++i) bytes.push_back(static_cast<char>((value >> (8 * i)) & 0xFFU));
}

/// `sound` is called for left and right, -1..1, at each time in seconds.
inline std::string wav_of(double seconds,
                          const std::function<std::pair<double, double>(double)>& sound,
                          int rate_hz = kWavRateHz) {
  const auto count = static_cast<std::uint32_t>(seconds * rate_hz);
  const auto rate = static_cast<std::uint32_t>(rate_hz);
  std::string bytes = "RIFF";
  append_little(bytes, 36 + 4 * count, 4);
  bytes += "WAVEfmt ";
  append_little(bytes, 16, 4);
  append_little(bytes, 1, 2);
  append_little(bytes, 2, 2);
  append_little(bytes, rate, 4);
  append_little(bytes, 4 * rate, 4);
  append_little(bytes, 4, 2);
  append_little(bytes, 16, 2);
  bytes += "data";
  append_little(bytes, 4 * count, 4);
  for (std::uint32_t i = 0; i < count; ++i) {
    const auto [left, right] = sound(static_cast<double>(i) / rate_hz);
    for (const double value : {left, right}) {
      const auto sample =
          static_cast<std::int32_t>(std::lround(32'767.0 * std::clamp(value, -1.0, 1.0)));
      append_little(bytes, static_cast<std::uint32_t>(sample), 2);
    }
  }
  return bytes;
}

/// A decaying tone of 2 kHz, 5 ms long.
inline double click(double t, double at) {
  const double since = t - at;
  if (since < 0.0 || since > 0.005) return 0.0;
  return std::exp(-since / 0.001) * std::cos(2.0 * std::numbers::pi * 2000.0 * since);
}

inline double sine(double t, double hz) { return std::sin(2.0 * std::numbers::pi * hz * t); }

}  // namespace hedgehog::client
