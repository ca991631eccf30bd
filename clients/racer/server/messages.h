// SPDX-License-Identifier: MIT
// What the game and its page say to each other, as values and as JSON texts, one object each with
// its `type`. Lengths in metres, turns as [w, x, y, z], the car's frame as everywhere: x front, y
// left, z up. Pure.
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

/// Who has the wheel.
enum class Mode : std::uint8_t { kBall, kKeyboard, kDriver };
std::string_view name(Mode mode) noexcept;
std::optional<Mode> mode_of(std::string_view name) noexcept;

/// What is on the page besides the scene.
struct Stand {
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

/// The ball and what it still can do.
struct BallView {
  bool connected = false;
  bool simulated = false;
  std::string state{};  // of the protocol: "armed"
  std::optional<double> temperature_c{};
  std::optional<double> limit_a{};
  std::optional<double> budget{};  // 1: cool; 0: only what can flow for ever is left
  double gain = 1.0;               // what the game lowers its own strength to
  bool derated = false;
  std::string reason{};  // a sentence, what is wrong and what helps; empty: nothing
  friend bool operator==(const BallView&, const BallView&) = default;
};

/// What was just played on the ball, or would have been.
struct Felt {
  std::string_view kind;  // "hit", "landing", "skid", "tumble"
  Vec3 direction{};       // where the pins push, in the ball's frame
  double strength = 0.0;  // 0..1 of the most that the game plays
  double level_a = 0.0;   // ampere; 0: no ball
};

std::string track_text(const Track& track);
std::string scene_text(const Scene& scene, const Stand& stand);
std::string ball_text(const BallView& ball);
std::string felt_text(const Felt& felt);
std::string lap_text(const FinishedLap& lap);
/// The game ends, by itself.
std::string shutdown_text(std::string_view reason);
std::string refusal_text(std::string_view why);

struct KeysHeld {
  Controls controls{};
};
struct ResetWanted {};
struct PauseWanted {
  bool on = true;
};
struct ModeWanted {
  Mode mode = Mode::kKeyboard;
};
/// Why a text is none of ours, as a sentence.
struct NotUnderstood {
  std::string why;
};
using PageMessage = std::variant<NotUnderstood, KeysHeld, ResetWanted, PauseWanted, ModeWanted>;

/// {"type":"keys","steer":-1..1,"throttle":0..1,"brake":0..1}, {"type":"reset"},
/// {"type":"pause","on":true}, {"type":"mode","mode":"ball"|"keyboard"|"driver"}.
PageMessage page_message(std::string_view text);

}  // namespace hedgehog::racer
