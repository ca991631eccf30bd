// SPDX-License-Identifier: MIT
// A haptic effect as a value: where the pins push, how strongly and for how long. All ranges are
// checked before a spec is made (protocol, server), not here. Source: protocol/README.md; thesis
// sections 3.2 (circular pattern, 2 cm pitch) and 4.1 (pulse, vibration).
#pragma once

#include <cstdint>

#include "model/geometry/pin_array.h"
#include "model/quaternion.h"
#include "model/tick.h"
#include "model/vec3.h"

namespace hedgehog::model {

enum class EffectMethod : std::uint8_t { kPulse, kCircle, kVibrate, kHold, kPlay };
enum class Path : std::uint8_t { kFixed, kCircle, kKeyframes };
enum class Frame : std::uint8_t { kDevice, kWorld, kCoil };
enum class Waveform : std::uint8_t { kConstant, kSine, kSquare, kTriangle, kSawtooth, kNoise };

/// kKeyframes: range of the control thread's key frames to play, and playback parameters.
struct KeyframePlayback {
  std::uint16_t first = 0;
  std::uint16_t count = 0;
  std::uint16_t length_ms = 1;     // time of the last key frame, at least 1
  bool loop = false;               // repeats from its beginning; false: level 0 after its end
  bool ends_with_pattern = false;  // `EffectSpec::duration` is its length at `rate`
  double rate = 1.0;               // playback speed, 0.1..10
  Quaternion turn;                 // rotation of the pattern, which faces front by default

  bool same_frames(const KeyframePlayback& other) const noexcept {
    return first == other.first && count == other.count;
  }
};

/// Direction of the field over time. Unit vectors, in the effect's frame.
struct Trajectory {
  Path path = Path::kFixed;
  Vec3 direction{1, 0, 0};             // kFixed: the direction in which the pins push out
  Vec3 axis{0, 0, 1};                  // kCircle: the axis of the circle
  double ring_deg = 90.0;              // angle from the axis, 0..180
  double pitch_deg = kThesisPitchDeg;  // from pin to pin at the equator, 1..120 (`pin_pitch_deg`)
  double speed_pins_s = 10.0;          // pin pitches a second, 0.1..100
  bool clockwise = false;
  bool smooth = false;  // moves continuously ("smooth"); false: jumps from pin to pin ("pin")
  KeyframePlayback playback;
};

/// Linear rise and fall inside the duration, in ticks; levels are fractions of the strength (0..1).
struct Envelope {
  Tick attack = 0;
  Tick fade = 0;
  double attack_level = 0.0;
  double fade_level = 0.0;
};

/// Trivially copyable; passed from the io to the control thread by value.
struct EffectSpec {
  EffectMethod method = EffectMethod::kPulse;
  Frame frame = Frame::kDevice;
  Waveform waveform = Waveform::kConstant;
  std::uint8_t priority = 5;  // 0..9; only the highest active priority is felt
  /// When its connection closes, a timed effect plays to its end (2 s at most) instead of stopping.
  bool finish_on_close = false;
  Trajectory trajectory;
  double strength_a = 5.0;     // peak current in ampere-equivalents before `gain`, 0..15
  double gain = 1.0;           // 0..1
  double frequency_hz = 60.0;  // 0.5..250; used by every waveform but kConstant
  double on_fraction = 0.5;    // duty cycle of kSquare, 0.05..0.95
  Envelope envelope;
  Tick start_at = -1;  // absolute tick of the onset; -1: `delay` after the command was applied
  Tick delay = 0;
  /// Exactly one of the two is positive: the effect ends after `duration` ticks of playing, or
  /// `lease` ticks after the last start or update. Both at most 10 000.
  Tick duration = 150;
  Tick lease = 0;
};

/// Progress of a playing effect, accumulated so that an update of frequency or speed causes no
/// jump. Trivially copyable.
struct EffectPhase {
  Tick elapsed = 0;   // since the onset
  double wave = 0.0;  // position in the waveform's period, 0..1
  /// Steps on the circle modulo their number; or ms in the key frames, in a loop modulo its length.
  double steps = 0.0;
  std::uint32_t noise = 0x9e3779b9u;  // state of the noise generator
};

/// Steps in one turn: round(360 sin(ring_deg) / pitch_deg), at least 1; 15 at the thesis' equator.
int circle_steps(double ring_deg, double pitch_deg = kThesisPitchDeg) noexcept;

/// A trajectory with precomputed trigonometry: its directions are `along + cos(a) front + sin(a)
/// side`, a fixed one is `along` alone.
struct Ring {
  Vec3 along{1, 0, 0};
  Vec3 front{0, 0, 0};
  Vec3 side{0, 0, 0};
  int steps = 0;  // in a turn; 0 for a fixed direction
  bool smooth = false;
};
Ring ring_of(const Trajectory& trajectory) noexcept;
Vec3 direction_at(const Ring& ring, const EffectPhase& phase) noexcept;

/// Unit vector in the effect's frame. A circle begins at the front (+x), or, if its axis is along
/// x, at the top; counter-clockwise as seen from outside, looking against the axis.
Vec3 direction_at(const Trajectory& trajectory, const EffectPhase& phase) noexcept;

/// Envelope times waveform, 0..1, without the level of key frames. A leased effect has no fade. All
/// waveforms are in 0..1; all but kSquare and kNoise start at 0; noise interpolates between
/// `frequency_hz` random levels a second.
double level_at(const EffectSpec& spec, const EffectPhase& phase) noexcept;

/// `phase` advanced by `ticks` (>= 0), or by one. `ring` is `ring_of(spec.trajectory)`.
EffectPhase advanced(const EffectSpec& spec, const Ring& ring, EffectPhase phase,
                     Tick ticks) noexcept;
EffectPhase advanced(const EffectSpec& spec, EffectPhase phase) noexcept;

/// `phase` after an update of the spec: the field stays at the same angle of the circle, whatever
/// the steps and the sense; the same key frames continue, different ones start from the beginning.
EffectPhase carried(const EffectSpec& from, const EffectSpec& to, EffectPhase phase) noexcept;

/// Ticks from `at_ms` to the end of the key frames.
Tick ticks_to_end(const KeyframePlayback& playback, double at_ms) noexcept;

/// RMS over one period of the waveform, relative to its peak; kSquare: sqrt(on_fraction).
double rms_fraction(const EffectSpec& spec) noexcept;

}  // namespace hedgehog::model
