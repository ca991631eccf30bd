// SPDX-License-Identifier: MIT
// A sound as effects, in slices of half a second. If the sender hangs, only slices sent ahead still
// play.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

#include "clients/sound/analyser.h"
#include "protocol/values/effect_params.h"

namespace hedgehog::sound {

inline constexpr int kSliceMs = 500;
/// Length of the push of an onset: that of the shipped `tick`.
inline constexpr int kPulseMs = 25;

struct SliceOptions {
  /// The crossover between vibration and pulses, kMinLowHz..kMaxLowHz.
  double low_hz = 150.0;
  /// Gains of the amplitudes in the file, which are then clamped to 1; 0 omits the pulses, or the
  /// vibration.
  double pulses = 1.0;
  double vibration = 1.0;
  /// Level of the perception threshold, 0..1: amplitudes 0..1 are mapped to felt..1.
  double felt = 0.0;
};

/// The key frames of `kSliceMs` of a sound; their times are relative to its beginning.
struct Slice {
  std::int64_t start_ms = 0;  // in the sound
  /// Two per push, as steps. The last push may end up to kPulseMs after the slice. Empty: no onset.
  std::vector<protocol::Keyframe> pulses;
  /// The envelope of the low band, linear; continuous between slices. Empty: nothing to feel.
  std::vector<protocol::Keyframe> vibration;
  /// Frequency of the vibration: the low band's, rounded to whole periods per slice, so that the
  /// phase is continuous; 20 Hz to the crossover, at most 250.
  double frequency_hz = 60.0;
};

/// Left +90, right -90, equal levels 0: from the angle of equal-power panning.
double azimuth_deg(double left, double right) noexcept;

/// Converts a file to slices, in order.
class SliceReader {
 public:
  SliceReader(SoundFile file, const SliceOptions& options);

  /// The next one; nullopt after the end.
  std::optional<Slice> next();
  double seconds() const noexcept { return file_.seconds(); }

 private:
  /// A slice requires its windows, one more, and all onsets until its end.
  bool has_enough() const;
  void read_more();
  void add_pulses(Slice& slice);
  void add_vibration(Slice& slice);
  double level(double amplitude, double gain) const;

  SoundFile file_;
  SliceOptions options_;
  SoundAnalyser analyser_;
  bool ended_ = false;
  std::int64_t start_ms_ = 0;
  LowWindow last_window_{};
  double last_azimuth_deg_ = 0.0;
  std::deque<LowWindow> windows_{};
  std::deque<Onset> onsets_{};
};

}  // namespace hedgehog::sound
