// SPDX-License-Identifier: MIT
// hedgehogctl board flash with a real daemon and the simulated board: into a folder that resembles
// the boot loader's volume, or by a program called picotool.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "tests/clients/uf2_sample.h"
#include "tests/e2e/daemon_process.h"
#include "tests/e2e/exit_codes.h"
#include "tests/e2e/program.h"
#include "tests/e2e/programs.h"
#include "tests/e2e/raw_client.h"

namespace hedgehog::e2e {
namespace {

using client::Uf2Sample;
using testing::ContainsRegex;
using testing::HasSubstr;
using testing::IsEmpty;

namespace fs = std::filesystem;

/// Runs without a daemon.
struct BoardFlashFile : testing::Test {
  Home home;
  std::string image = Uf2Sample::pages(40).text();

  void SetUp() override { home.write("new.uf2", image); }
  std::string file() const { return home.path("new.uf2"); }
  Ended flash(const std::vector<std::string>& more,
              const std::vector<std::string>& variables = {}) const {
    std::vector<std::string> words{"board", "flash", file()};
    words.insert(words.end(), more.begin(), more.end());
    return Program(home, hedgehogctl(), words, variables).wait();
  }
};

TEST_F(BoardFlashFile, CheckNeedsNoDaemon) {
  const Ended text = flash({"--check"});
  EXPECT_EQ(text.exit_code, 0) << text.err;
  EXPECT_EQ(text.out, "  file      " + file() + ": 40 blocks, 10 240 bytes below 0x10002800\n");
  const Ended json = flash({"--check", "--json"});
  EXPECT_EQ(Json::parse(json.out), Json({{"file", file()}, {"blocks", 40}, {"bytes", 10'240}}));
}

TEST_F(BoardFlashFile, ABadFileIsRefusedBeforeAnyRequest) {
  home.write("new.uf2", image.substr(0, 512 * 39));
  const Ended ended = flash({});
  EXPECT_EQ(ended.exit_code, kBadData);
  EXPECT_THAT(ended.out, IsEmpty());
  EXPECT_EQ(ended.err,
            "hedgehogctl: " + file() + ": block 0 counts 40 blocks, and the file has 39\n");
  const Ended json = flash({"--json"});
  EXPECT_EQ(json.exit_code, kBadData);
  EXPECT_EQ(Json::parse(json.err)["error"]["data"]["name"], "bad_data");
  fs::remove(file());
  EXPECT_EQ(flash({"--check"}).exit_code, kNoInput);
}

struct BoardFlashed : BoardFlashFile {
  // The three seconds in the boot loader take 0.3 s.
  DaemonProcess daemon{home, {"--speed", "10"}};
  RawClient other{daemon.port()};

  std::string volume() const {
    home.write("RPI-RP2/INFO_UF2.TXT", "UF2 Bootloader v3.0\r\nBoard-ID: RPI-RP2\r\n");
    return home.path("RPI-RP2");
  }
  /// A program named picotool, first in PATH, that records its arguments. `before`: shell commands
  /// that it runs afterwards.
  std::string path_with_picotool(const std::string& before) const {
    home.write("bin/picotool", "#!/bin/sh\necho \"$@\" >>'" + home.path("asked") + "'\n" + before);
    fs::permissions(home.path("bin/picotool"), fs::perms::owner_all);
    const char* path = std::getenv("PATH");
    return "PATH=" + home.path("bin") + ":" + (path != nullptr ? path : "/usr/bin:/bin");
  }
  Ended flash(const std::vector<std::string>& more, std::vector<std::string> variables = {}) const {
    variables.push_back("HEDGEHOG_ADDRESS=" + daemon.socket());
    return BoardFlashFile::flash(more, variables);
  }
  void stop() { other.call("device.emergency_stop"); }
  Json status() { return other.call("device.status"); }
};

TEST_F(BoardFlashed, AnArmedBallIsNotFlashed) {
  const Ended ended = flash({"--volume", volume()});
  EXPECT_EQ(ended.exit_code, kTryLater);
  EXPECT_THAT(ended.err,
              HasSubstr("the boot loader can be entered only while the ball is not armed. Run: "
                        "hedgehogctl stop"));
  EXPECT_EQ(status()["state"], "armed");
  EXPECT_FALSE(fs::exists(home.path("RPI-RP2/hedgehog.uf2")));
}

TEST_F(BoardFlashed, ThroughAVolume) {
  stop();
  const Ended ended = flash({"--volume", volume()});
  EXPECT_EQ(ended.exit_code, 0) << ended.err;
  EXPECT_THAT(ended.out, HasSubstr("  board     is in its boot loader\n"));
  EXPECT_THAT(ended.out, HasSubstr("  written   to " + home.path("RPI-RP2") + "\n"));
  EXPECT_THAT(ended.out, ContainsRegex("  firmware  not known .* not known\n"));
  EXPECT_THAT(ended.out, ContainsRegex("  protocol  1.2 .* 1.2\n"));
  EXPECT_THAT(ended.out, HasSubstr("  disarmed  Run: hedgehogctl arm\n"));
  EXPECT_THAT(ended.err, HasSubstr("the ball is simulated"));
  EXPECT_EQ(home.read("RPI-RP2/hedgehog.uf2"), image);
  EXPECT_EQ(status()["state"], "disarmed");
  EXPECT_EQ(other.call("events.history", {{"trips", true}})["events"], Json::array());
  EXPECT_EQ(other.call("device.arm")["state"], "armed");
}

TEST_F(BoardFlashed, ByPicotoolWhichFindsTheDeviceAtItsSecondAttempt) {
  stop();
  const std::string path = path_with_picotool(
      "[ -e '" + home.path("tried") + "' ] && exit 0\n: >'" + home.path("tried") +
      "'\necho 'No accessible RP2040 devices in BOOTSEL mode were found.'\nexit 249\n");
  const Ended ended = flash({"--json"}, {path});
  EXPECT_EQ(ended.exit_code, 0) << ended.err;
  const Json report = Json::parse(ended.out);
  EXPECT_EQ(report["written_by"], "picotool");
  EXPECT_EQ(report["volume"], nullptr);
  EXPECT_EQ(report["protocol"], Json({{"before", "1.2"}, {"after", "1.2"}}));
  EXPECT_EQ(report["state"], "disarmed");
  const std::string command = "load -x " + file() + "\n";
  EXPECT_EQ(home.read("asked"), command + command);
}

TEST_F(BoardFlashed, ErrorsOfPicotoolAreShown) {
  stop();
  const Ended ended =
      flash({"--wait-s", "0"}, {path_with_picotool("echo 'No permission.' >&2\nexit 1\n")});
  EXPECT_EQ(ended.exit_code, kUnavailable);
  EXPECT_THAT(ended.err, HasSubstr("picotool failed: No permission."));
}

TEST_F(BoardFlashed, WithoutABoardTheDaemonGetsNoRequest) {
  other.call("sim.set", {{"fault", {{"faults", {"silent"}}}}});
  ASSERT_TRUE(eventually([&] { return status()["state"] == "absent"; }));
  const Ended ended = flash({"--volume", home.path("nothing")});
  EXPECT_EQ(ended.exit_code, kUnavailable);
  EXPECT_THAT(ended.err, HasSubstr("is not the volume RPI-RP2 of a board in its boot loader"));
}

TEST_F(BoardFlashed, CtrlCLeavesTheBoardInItsBootLoader) {
  stop();
  Program program(home, hedgehogctl(), {"board", "flash", file(), "--volume", home.path("nothing")},
                  {"HEDGEHOG_ADDRESS=" + daemon.socket()});
  EXPECT_TRUE(program.prints("is in its boot loader"));
  program.signal(SIGINT);
  const Ended ended = program.wait();
  EXPECT_EQ(ended.exit_code, kInterrupted);
  EXPECT_THAT(ended.err, HasSubstr("interrupted; the board stays in its boot loader"));
}

}  // namespace
}  // namespace hedgehog::e2e
