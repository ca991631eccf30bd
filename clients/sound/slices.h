// SPDX-License-Identifier: MIT
// A sound as effects, half a second at a time. What has been sent ahead plays on when the sender
// hangs.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

#include "clients/sound/analyser.h"
#include "protocol/values/effect_params.h"

namespace hedgehog::sound {

inline constexpr int kSliceMs = 500;
/// A push of an onset: that of the shipped `tick`.
inline constexpr int kPulseMs = 25;

struct SliceOptions {
  /// The crossover between vibration and pulses, kMinLowHz..kMaxLowHz.
  double low_hz = 150.0;
  /// Multiply the amplitudes in the file before they are cut at 1; 0 leaves the pulses, or the
  /// vibration, out.
  double pulses = 1.0;
  double vibration = 1.0;
  /// The level below which nothing is felt, 0..1: amplitude 0..1 becomes felt..1.
  double felt = 0.0;
};

/// The key frames of `kSliceMs` of a sound; their times count from its beginning.
struct Slice {
  std::int64_t start_ms = 0;  // in the sound
  /// Two a push, steps. The last may end up to kPulseMs behind the slice. Empty: no onset.
  std::vector<protocol::Keyframe> pulses;
  /// The envelope of the low band, straight lines; it goes on in the next slice where this one
  /// ends. Empty: nothing to feel.
  std::vector<protocol::Keyframe> vibration;
  /// Of the vibration: the low band's, as a number of whole periods a slice, so that the phase goes
  /// on in the next one; 20 Hz to the crossover, at most 250.
  double frequency_hz = 60.0;
};

/// Left +90, right -90, both alike 0: by the angle of equal-power panning.
double azimuth_deg(double left, double right) noexcept;

/// Turns a file into slices, in order.
class SliceReader {
 public:
  SliceReader(SoundFile file, const SliceOptions& options);

  /// The next one; nullopt behind the end.
  std::optional<Slice> next();
  double seconds() const noexcept { return file_.seconds(); }

 private:
  /// A slice needs its windows, one more, and the onsets of its time.
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
