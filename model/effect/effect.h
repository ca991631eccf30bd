// SPDX-License-Identifier: MIT
// A haptic effect as a value: where the pins push (trajectory, frame), how strongly (strength,
// gain, waveform, envelope) and for how long. All ranges are checked before a spec is made
// (protocol, server); the functions below do not check them again. Source: protocol/README.md;
// thesis sections 3.2 (circular pattern, 2 cm pitch) and 4.1 (pulse, vibration).
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
  /// Time of the last key frame, at least 1.
  std::uint16_t length_ms = 1;
  /// Repeats from its beginning; false: level 0 after its end.
  bool loop = false;
  /// The effect ends with the pattern: `EffectSpec::duration` is the pattern's length at `rate`.
  bool ends_with_pattern = false;
  /// Playback speed, 0.1..10.
  double rate = 1.0;
  /// Rotation of the pattern, which faces front by default.
  Quaternion turn;

  /// True if both refer to the same range of key frames.
  bool same_frames(const KeyframePlayback& other) const noexcept {
    return first == other.first && count == other.count;
  }
};

/// Direction of the field over time. Unit vectors, in the effect's frame.
struct Trajectory {
  Path path = Path::kFixed;
  /// kFixed: the direction in which the pins push out.
  Vec3 direction{1, 0, 0};
  /// kCircle: the axis, the angle from it (0..180 degrees), pin pitches a second (0.1..100), and
  /// the sense.
  Vec3 axis{0, 0, 1};
  double ring_deg = 90.0;
  /// Step from pin to pin at the equator, 1..120 degrees (`pin_pitch_deg`).
  double pitch_deg = kThesisPitchDeg;
  double speed_pins_s = 10.0;
  bool clockwise = false;
  /// false: the field jumps from pin to pin ("pin"); true: it moves continuously ("smooth").
  bool smooth = false;
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
  /// 0..9; only the highest active priority is felt.
  std::uint8_t priority = 5;
  /// When its connection closes, a timed effect plays to its end (2 s at most) instead of stopping.
  bool finish_on_close = false;
  Trajectory trajectory;
  /// Peak current in ampere-equivalents before `gain`, 0..15.
  double strength_a = 5.0;
  /// 0..1.
  double gain = 1.0;
  /// 0.5..250; used by every waveform but kConstant.
  double frequency_hz = 60.0;
  /// Duty cycle of kSquare, 0.05..0.95.
  double on_fraction = 0.5;
  Envelope envelope;
  /// Absolute tick of the onset, or -1: `delay` ticks after the command was applied.
  Tick start_at = -1;
  Tick delay = 0;
  /// Exactly one of the two is positive: the effect ends after `duration` ticks of playing, or
  /// `lease` ticks after the last start or update. Both at most 10 000.
  Tick duration = 150;
  Tick lease = 0;
};

/// Progress of a playing effect. Phases are accumulated, not computed from time, so that an update
/// of frequency or speed causes no jump. Trivially copyable.
struct EffectPhase {
  /// Ticks since the onset.
  Tick elapsed = 0;
  /// Position in the waveform's period, 0..1.
  double wave = 0.0;
  /// Position on the circle in steps, modulo their number; or in the key frames in milliseconds,
  /// modulo their length when they loop.
  double steps = 0.0;
  /// State of the noise generator.
  std::uint32_t noise = 0x9e3779b9u;
};

/// Number of equal steps in one turn of a circle `ring_deg` from its axis: round(360 sin(ring_deg)
/// / pitch), at least 1. 15 at the equator with the thesis' pitch of 2 cm.
int circle_steps(double ring_deg, double pitch_deg = kThesisPitchDeg) noexcept;

/// A trajectory with precomputed trigonometry, for the control loop. Its directions are `along +
/// cos(a) front + sin(a) side`; a fixed direction is `along` alone.
struct Ring {
  Vec3 along{1, 0, 0};
  Vec3 front{0, 0, 0};
  Vec3 side{0, 0, 0};
  /// Steps in a turn; 0 for a fixed direction.
  int steps = 0;
  bool smooth = false;
};
Ring ring_of(const Trajectory& trajectory) noexcept;
Vec3 direction_at(const Ring& ring, const EffectPhase& phase) noexcept;

/// The direction of `trajectory` at `phase`: a unit vector in the effect's frame. The first step of
/// a circle is at the front (+x), or, when the axis is along x, at the top. Counter-clockwise as
/// seen from outside, looking against the axis.
Vec3 direction_at(const Trajectory& trajectory, const EffectPhase& phase) noexcept;

/// Envelope times waveform at `phase`, 0..1, without the level of key frames. A leased effect has
/// no fade: its end is not known in advance. Every waveform is in 0..1 and, except kSquare and
/// kNoise, starts at 0; noise interpolates between `frequency_hz` random levels a second.
double level_at(const EffectSpec& spec, const EffectPhase& phase) noexcept;

/// `phase` advanced by `ticks` (>= 0). `ring` is `ring_of(spec.trajectory)`.
EffectPhase advanced(const EffectSpec& spec, const Ring& ring, EffectPhase phase,
                     Tick ticks) noexcept;
/// `phase` advanced by one tick.
EffectPhase advanced(const EffectSpec& spec, EffectPhase phase) noexcept;

/// `phase` of an effect whose spec changes from `from` to `to`: the field stays at the same angle
/// of the circle even if the number of steps or the sense changes; the same key frames continue,
/// different ones start from the beginning.
EffectPhase carried(const EffectSpec& from, const EffectSpec& to, EffectPhase phase) noexcept;

/// Ticks from `at_ms` to the end of the key frames.
Tick ticks_to_end(const KeyframePlayback& playback, double at_ms) noexcept;

/// Root mean square over one period of the waveform, as a fraction of the peak (square with
/// on_fraction f: sqrt(f)).
double rms_fraction(const EffectSpec& spec) noexcept;

}  // namespace hedgehog::model
