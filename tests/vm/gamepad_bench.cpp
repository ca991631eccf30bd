// SPDX-License-Identifier: MIT
#include "tests/vm/gamepad_bench.h"

#include <cstdio>
#include <sstream>

#include "tests/e2e/json_vector.h"
#include "tests/e2e/programs.h"

namespace hedgehog::vm {

ff_effect constant(int direction, int level, int length_ms) {
  ff_effect effect{};
  effect.type = FF_CONSTANT;
  effect.id = -1;
  effect.direction = static_cast<std::uint16_t>(direction);
  effect.replay.length = static_cast<std::uint16_t>(length_ms);
  effect.u.constant.level = static_cast<std::int16_t>(level);
  return effect;
}

ff_effect rumble() {
  ff_effect effect{};
  effect.type = FF_RUMBLE;
  effect.id = -1;
  effect.u.rumble = {0xffff, 0};
  return effect;
}

ff_effect wave(int waveform, int direction) {
  ff_effect effect{};
  effect.type = FF_PERIODIC;
  effect.id = -1;
  effect.direction = static_cast<std::uint16_t>(direction);
  effect.u.periodic.waveform = static_cast<std::uint16_t>(waveform);
  effect.u.periodic.period = 50;
  effect.u.periodic.magnitude = kFull;
  return effect;
}

bool stick_reaches(const EventNode& game, int x, int y) {
  const auto reached = [](int value, int goal) {
    if (goal == 0) return value == 0;
    return goal > 0 ? value >= goal : value <= goal;
  };
  while (!reached(game.axis(ABS_X).value, x) || !reached(game.axis(ABS_Y).value, y))
    if (!game.next()) return false;
  return true;
}

GamepadBench::GamepadBench() {
  // Without a configuration the daemon simulates a ball.
  daemon_.emplace(home_);
  daemon_->arm();
  ball_.emplace(home_.path("run/hedgehog/hedgehogd.sock"));
}

void GamepadBench::begin(const std::vector<std::string>& options, const std::string& user) {
  std::vector<std::string> words{e2e::hedgehog_gamepad()};
  words.insert(words.end(), options.begin(), options.end());
  bridge_.emplace(words, home_.environment(), home_.path("bridge"), user);
  ASSERT_TRUE(bridge_logs("is the centre of the stick")) << bridge_log();
  ASSERT_FALSE(node().empty()) << shell("ls -l /dev/input");
}

bool GamepadBench::bridge_logs(const std::string& text) const {
  return eventually([&] { return bridge_log().find(text) != std::string::npos; });
}

void GamepadBench::turn(const model::Quaternion& q) {
  daemon_->call("sim.set", {{"orientation", e2e::json_of(q)}});
}

std::vector<std::string> GamepadBench::debian_environment() const {
  std::vector<std::string> variables = home_.environment();
  std::erase_if(variables, [](const std::string& one) { return one.starts_with("PATH="); });
  variables.emplace_back("PATH=/usr/bin:/bin");
  return variables;
}

std::vector<std::string> GamepadBench::game_commands() const {
  static const std::string kBegin = "hedgehog-gamepad: game: ";
  std::vector<std::string> commands;
  std::istringstream log(bridge_log());
  for (std::string line; std::getline(log, line);)
    if (line.starts_with(kBegin)) commands.push_back(line.substr(kBegin.size()));
  return commands;
}

void GamepadBench::print(const std::string& program) const {
  std::printf("  %s sent:\n", program.c_str());
  for (const std::string& command : game_commands()) std::printf("    %s\n", command.c_str());
  std::printf("  the ball:\n%s", ball_->text().c_str());
  std::fflush(stdout);
}

}  // namespace hedgehog::vm
