// SPDX-License-Identifier: MIT
// A Debian game, unmodified, that is steered by the ball: Chocolate Doom with Freedoom's first map.
// It records the stick's values in each of its ticks, 35 a second.
#include <algorithm>
#include <filesystem>
#include <vector>

#include "tests/vm/gamepad_bench.h"
#include "tests/vm/screen.h"

namespace hedgehog::vm {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

constexpr int kPollMs = 100;
constexpr int kCloseMs = 500;
// Four bytes a tick: two hours of play.
constexpr const char* kRecordingKiB = "1024";

/// One tick of a game's recording.
struct Steering {
  int forward = 0;  // forward is positive
  int turn = 0;     // left is positive
};

std::vector<Steering> steering_of(const std::string& demo) {
  constexpr std::size_t kHeaderBytes = 13;
  constexpr std::size_t kTickBytes = 4;  // forwards, sideways, turn, buttons
  const auto number = [&](std::size_t at) {
    return static_cast<int>(static_cast<signed char>(demo[at]));
  };
  std::vector<Steering> ticks;
  for (std::size_t at = kHeaderBytes; at + kTickBytes < demo.size(); at += kTickBytes)
    ticks.push_back({number(at), number(at + 2)});
  return ticks;
}

/// Whether a process has the file open.
bool holds(pid_t process, const std::string& file) {
  const fs::directory_iterator all("/proc/" + std::to_string(process) + "/fd");
  return std::any_of(begin(all), end(all), [&](const fs::directory_entry& one) {
    std::error_code closed;
    return fs::read_symlink(one.path(), closed) == file;
  });
}

class GamepadGame : public GamepadBench {
 protected:
  void SetUp() override {
    begin({"--trace"});
    // The file that the game's own setup writes when a person selects a gamepad.
    home_.write("player.cfg", "use_joystick 1\nscreenblocks 7\n");
    home_.write(
        "machine.cfg",
        "joystick_guid \"" + guid() +
            "\"\njoystick_index 0\njoystick_x_axis 0\njoystick_y_axis 1\n"
            "startup_delay 0\nforce_software_renderer 1\nfullscreen 0\naspect_ratio_correct 0\n");
  }
  /// The id by which SDL identifies the gamepad.
  std::string guid() const {
    const std::string printed = shell(
        "/usr/bin/python3 -c 'import ctypes; sdl = ctypes.CDLL(\"libSDL2-2.0.so.0\"); "
        "sdl.SDL_Init(0x200); "
        "guid = type(\"G\", (ctypes.Structure,), {\"_fields_\": [(\"data\", ctypes.c_ubyte * "
        "16)]}); "
        "ask = sdl.SDL_JoystickGetDeviceGUID; ask.restype = guid; "
        "print(bytes(ask(0).data).hex())'");
    EXPECT_EQ(printed.size(), 33U) << printed;
    return printed.substr(0, 32);
  }
  /// True if two pictures are the same and not black.
  static bool is_still(const Screen& screen) {
    const Picture before = screen.picture();
    pause_ms(200);
    return lit_share(before) > 0.4 && changed_share(before, screen.picture()) < 0.02;
  }
  /// True if the picture changes when the ball is tilted by `tilt`.
  bool changes_view(const Screen& screen, const model::Quaternion& tilt) {
    const Picture before = screen.picture();
    turn(tilt);
    return eventually([&] { return changed_share(before, screen.picture()) > 0.2; }, kPollMs,
                      kManyMinutes);
  }
};

TEST_F(GamepadGame, ChocolateDoomIsSteeredByTilting) {
  const Screen screen(home_);
  std::vector<std::string> environment = debian_environment();
  environment.push_back(Screen::display());
  environment.emplace_back("SDL_AUDIODRIVER=dummy");
  Child game({"/usr/games/chocolate-doom",
              "-iwad",
              "/usr/share/games/doom/freedoom1.wad",
              "-config",
              home_.path("player.cfg"),
              "-extraconfig",
              home_.path("machine.cfg"),
              "-window",
              "-geometry",
              "320x240",
              "-nosound",
              "-nograbmouse",
              "-warp",
              "1",
              "1",
              "-nomonsters",
              "-record",
              home_.path("tilt"),
              "-maxdemo",
              kRecordingKiB},
             environment, home_.path("game"));
  const auto printed = [&] { return home_.read("game"); };
  const auto until_still = [&] {
    return eventually([&] { return game.ended() || is_still(screen); }, kPollMs, kManyMinutes);
  };
  ASSERT_TRUE(until_still()) << printed();
  ASSERT_FALSE(game.ended()) << printed();
  EXPECT_TRUE(holds(game.pid(), node())) << printed();
  const auto tilt = [&](const model::Vec3& axis) {
    EXPECT_TRUE(changes_view(screen, model::axis_angle(axis, 60)));
    turn({});
    EXPECT_TRUE(until_still()) << printed();
  };
  tilt(kFront);  // to the right
  tilt(kLeft);   // to the front
  // The game asks for confirmation; a second close request confirms.
  std::string problem;
  const auto is_closed = [&] {
    if (!game.ended()) problem = screen.close_windows();
    return game.ended();
  };
  EXPECT_TRUE(eventually(is_closed, kCloseMs, kManyMinutes)) << problem;
  EXPECT_THAT(printed(), HasSubstr("recorded"));
  EXPECT_THAT(game_commands(), testing::Each(testing::StartsWith("gain "))) << "no effects";

  const std::vector<Steering> ticks = steering_of(home_.read("tilt.lmp"));
  ASSERT_FALSE(ticks.empty());
  const auto first = [&](auto&& is) {
    return std::find_if(ticks.begin(), ticks.end(), is) - ticks.begin();
  };
  const auto count = [&](auto&& is) { return std::count_if(ticks.begin(), ticks.end(), is); };
  const auto right = [](const Steering& tick) { return tick.turn < 0; };
  const auto left = [](const Steering& tick) { return tick.turn > 0; };
  const auto forwards = [](const Steering& tick) { return tick.forward > 0; };
  const auto backwards = [](const Steering& tick) { return tick.forward < 0; };
  EXPECT_GT(first(right), 0) << "still at first";
  EXPECT_LT(first(right), first(forwards)) << "in this order";
  EXPECT_GT(count(forwards), 0);
  EXPECT_EQ(count(left), 0);
  EXPECT_EQ(count(backwards), 0);
  EXPECT_EQ(ticks.back().turn, 0) << "still at last";
  EXPECT_EQ(ticks.back().forward, 0) << "still at last";
  std::printf("  chocolate-doom read of the stick: %td ticks to the right, %td forwards, of %zu\n",
              count(right), count(forwards), ticks.size());
}

}  // namespace
}  // namespace hedgehog::vm
