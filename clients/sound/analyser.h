// SPDX-License-Identifier: MIT
// Features of a sound that can be felt: onsets, and the strength of its low band.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "clients/sound/biquad.h"
#include "clients/sound/sound_file.h"

namespace hedgehog::sound {

/// The onset of a click, a drum, a note.
struct Onset {
  double t_ms = 0.0;  // from the beginning of the sound
  /// Peak amplitude above the crossover in its first 15 ms, per side, 0..1.
  double left = 0.0;
  double right = 0.0;
};

/// The low band of 25 ms of sound.
struct LowWindow {
  /// Amplitude of a sine of the same power, per side, 0..1.
  double left = 0.0;
  double right = 0.0;
  /// Number of upward zero crossings of the louder side.
  int periods = 0;
};

inline constexpr int kHopsPerSecond = 200;
inline constexpr int kHopsPerWindow = 5;
inline constexpr int kWindowMs = 1000 * kHopsPerWindow / kHopsPerSecond;
inline constexpr double kMinLowHz = 40.0;
inline constexpr double kMaxLowHz = 1000.0;

/// Onsets by energy: in hops of 5 ms, above the crossover, an onset is detected where the power of
/// a hop is four times (6 dB) that of each of the four before it and at least -50 dB of full scale,
/// and no other onset was within 60 ms. (Energy-based detection: J. P. Bello et al., "A tutorial on
/// onset detection in music signals", IEEE Trans. Speech Audio Process. 13(5), 2005.) The low band
/// is from 15 Hz to the crossover.
class SoundAnalyser {
 public:
  /// `rate_hz` 8000..192 000; `low_hz`, the crossover, kMinLowHz..kMaxLowHz.
  SoundAnalyser(double rate_hz, double low_hz);

  /// Adds the next samples of the sound.
  void add(std::span<const StereoSample> samples);
  /// Ends the sound: the last window is padded with silence.
  void finish();

  /// Results since the last call, in order.
  std::vector<Onset> take_onsets();
  std::vector<LowWindow> take_windows();
  /// All onsets before this time have been found, ms.
  double found_until_ms() const noexcept;

 private:
  struct Side {
    FourthOrder low;
    FourthOrder high;
    Biquad steady;  // removes the constant component
    Side(double rate_hz, double low_hz);

    double last_low = 0.0;
    double low_power = 0.0;  // sums of the window
    int periods = 0;
    double high_power = 0.0;  // sums and peaks of the hop
    double high_peak = 0.0;
  };

  void take_sample(Side& side, double value);
  void end_hop();
  void end_window();
  void find_onset(double power);

  double rate_hz_;
  std::array<Side, 2> sides_;
  std::vector<std::array<double, 2>> hop_{};  // peaks above the crossover so far in this hop
  std::int64_t samples_ = 0;
  std::int64_t hops_ = 0;
  std::int64_t window_samples_ = 0;
  std::array<double, 4> before_{};  // powers of the last hops
  std::int64_t last_onset_hop_;
  Onset growing_{};
  bool is_growing_ = false;
  std::vector<Onset> onsets_{};
  std::vector<LowWindow> windows_{};
};

}  // namespace hedgehog::sound
