// SPDX-License-Identifier: MIT
// The ball as a gamepad in the guest: a simulated ball, hedgehog-gamepad on uinput, and a log of
// the ball's effects.
#pragma once

#include <linux/input.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "model/quaternion.h"
#include "tests/vm/ball_log.h"
#include "tests/vm/bench.h"
#include "tests/vm/event_node.h"

namespace hedgehog::vm {

inline constexpr model::Vec3 kFront{1, 0, 0};
inline constexpr model::Vec3 kBack{-1, 0, 0};
inline constexpr model::Vec3 kLeft{0, 1, 0};
inline constexpr model::Vec3 kRight{0, -1, 0};
inline constexpr model::Vec3 kDown{0, 0, -1};

/// The name of hedgehog-gamepad's input device.
inline constexpr const char* kGamepadName = "Hedgehog haptic ball";

inline constexpr int kFull = 0x7fff;

/// As a game writes it; not uploaded yet.
ff_effect constant(int direction, int level, int length_ms = 0);
/// Of the strong motor, at its full magnitude.
ff_effect rumble();
/// Of full magnitude, 20 Hz.
ff_effect wave(int waveform, int direction);

/// True once both of the stick's axes are at or beyond these values, in the sense of their sign;
/// zero: exactly.
bool stick_reaches(const EventNode& game, int x, int y);

class GamepadBench : public testing::Test {
 protected:
  /// The simulated ball is armed.
  GamepadBench();

  /// Starts hedgehog-gamepad as `user`, and waits until its node exists and upright is the centre
  /// of its stick.
  void begin(const std::vector<std::string>& options = {}, const std::string& user = "");
  std::string bridge_log() const { return home_.read("bridge"); }
  bool bridge_logs(const std::string& text) const;
  /// The gamepad's event node; empty when there is none.
  static std::string node() { return event_node(kGamepadName); }
  /// Sets the simulated ball's orientation: device -> world.
  void turn(const model::Quaternion& q);
  /// NAME=VALUE for Debian's programs, which find only Debian's own interpreters.
  std::vector<std::string> debian_environment() const;
  /// What the games have uploaded and played, a line each, if the bridge has the option --trace.
  std::vector<std::string> game_commands() const;
  /// Prints in the test's output what `program` sent to the gamepad and what the ball did.
  void print(const std::string& program) const;

  Home home_;
  std::optional<Daemon> daemon_;
  std::optional<BallLog> ball_;
  std::optional<Child> bridge_;
};

}  // namespace hedgehog::vm
