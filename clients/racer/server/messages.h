// SPDX-License-Identifier: MIT
// Messages between the game and its page, as values and as JSON texts, one object each with its
// `type`. Lengths in metres, orientations as [w, x, y, z], the car's frame: x front, y left, z up.
// Pure.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "clients/racer/game/controls.h"
#include "clients/racer/game/scene.h"
#include "clients/racer/game/track.h"

namespace hedgehog::racer {

/// Source of the controls.
enum class Mode : std::uint8_t { kBall, kKeyboard, kDriver };
std::string_view name(Mode mode) noexcept;
std::optional<Mode> mode_of(std::string_view name) noexcept;

/// State of the game besides the scene.
struct GameStatus {
  Mode mode = Mode::kKeyboard;
  bool paused = false;
  std::optional<double> best_lap_s{};  // of the player's own
};

/// A lap that was just finished.
struct FinishedLap {
  int lap = 1;
  double time_s = 0.0;
  bool best = false;    // of the player's own
  bool driver = false;  // driven by the built-in driver, at least in part
};

/// Status of the ball and its thermal headroom.
struct BallView {
  bool connected = false;
  bool simulated = false;
  std::string state{};  // in the protocol's words: "armed"
  std::optional<double> temperature_c{};
  std::optional<double> limit_a{};
  std::optional<double> budget{};  // 1: cool; 0: only the continuous current is left
  double gain = 1.0;               // of the game's own strength
  bool derated = false;
  std::string reason{};  // a sentence with problem and remedy; empty: none
  friend bool operator==(const BallView&, const BallView&) = default;
};

/// An effect that was just played, or would have been with a ball.
struct Felt {
  std::string_view kind;  // "hit", "landing", "skid", "tumble"
  Vec3 direction{};       // where the pins push, in the device frame
  double strength = 0.0;  // 0..1, relative to the game's maximum
  double level_a = 0.0;   // ampere; 0: no ball
};

std::string track_text(const Track& track);
std::string scene_text(const Scene& scene, const GameStatus& stand);
std::string ball_text(const BallView& ball);
std::string felt_text(const Felt& felt);
std::string lap_text(const FinishedLap& lap);
/// The game ends.
std::string shutdown_text(std::string_view reason);
std::string refusal_text(std::string_view why);

struct KeysHeld {
  Controls controls{};
};
struct ResetRequest {};
struct PauseRequest {
  bool on = true;
};
struct ModeRequest {
  Mode mode = Mode::kKeyboard;
};
/// Why a message is invalid, as a sentence.
struct InvalidMessage {
  std::string why;
};
using PageMessage = std::variant<InvalidMessage, KeysHeld, ResetRequest, PauseRequest, ModeRequest>;

/// {"type":"keys","steer":-1..1,"throttle":0..1,"brake":0..1}, {"type":"reset"},
/// {"type":"pause","on":true}, {"type":"mode","mode":"ball"|"keyboard"|"driver"}.
PageMessage page_message(std::string_view text);

}  // namespace hedgehog::racer
