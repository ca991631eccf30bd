// SPDX-License-Identifier: MIT
// Other files or directories at the paths of the daemon's state files: the daemon starts
// nevertheless and reports them.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>
#include <string>

#include "tests/e2e/daemon_process.h"
#include "tests/e2e/raw_client.h"

namespace hedgehog::e2e {
namespace {

namespace fs = std::filesystem;

class StateFiles : public testing::Test {
 protected:
  std::string place(const std::string& name) const {
    const std::string path = home_.path("state/hedgehog/" + name);
    fs::create_directories(fs::path(path).parent_path());
    return path;
  }
  void fifo(const std::string& name) { EXPECT_EQ(::mkfifo(place(name).c_str(), 0600), 0); }
  void link(const std::string& name, const std::string& to) { fs::create_symlink(to, place(name)); }

  Home home_;
};

TEST_F(StateFiles, NoneOfThemNeedsToBeARegularFile) {
  fifo("trips.jsonl");
  fifo("effects.jsonl.1");
  fifo("telemetry.bin");
  fifo("patterns/acme/knock.json");
  link("effects.jsonl", "/dev/full");
  link("events.jsonl", "/dev/zero");
  fs::create_directory(place("events.jsonl.1"));
  DaemonProcess daemon(home_);
  EXPECT_EQ(RawClient(daemon.port()).call("device.status")["state"], "armed");
  for (const char* refused :
       {"trips.jsonl: is a FIFO, not a regular file",
        "effects.jsonl.1: is a FIFO, not a regular file",
        "telemetry.bin: is a FIFO, not a regular file", "knock.json: is a FIFO, not a regular file",
        "effects.jsonl: is a device, not a regular file",
        "events.jsonl: is a device, not a regular file",
        "events.jsonl.1: is a folder, not a regular file"})
    EXPECT_TRUE(daemon.logs(refused)) << refused;
  EXPECT_EQ(daemon.stop(), 0);
}

TEST_F(StateFiles, AStateThatIsNoRegularFileCountsAsLost) {
  const auto start = [&](const std::string& reason) {
    DaemonProcess daemon(home_);
    EXPECT_TRUE(daemon.logs("state.json: " + reason + ". Latch and temperature are unknown"));
    const Json status = RawClient(daemon.port()).call("device.status");
    EXPECT_EQ(status["state"], "tripped");
    EXPECT_EQ(status["reason"], "state_lost");
    daemon.stop(SIGKILL);
    fs::remove_all(place("state.json"));
  };
  fifo("state.json");
  start("is a FIFO, not a regular file");
  for (const char* device : {"/dev/full", "/dev/zero"}) {
    link("state.json", device);
    start("is a device, not a regular file");
  }
  fs::create_directory(place("state.json"));
  start("is a folder, not a regular file");
  home_.write("state/hedgehog/state.json", std::string(1 << 20, ' '));
  start("is larger than 64 KiB");
}

TEST_F(StateFiles, AFifoInPlaceOfAHalfWrittenStateBlocksNothing) {
  DaemonProcess(home_).stop();
  fifo("state.json.new");
  DaemonProcess daemon(home_);
  EXPECT_EQ(RawClient(daemon.port()).call("device.status")["state"], "armed");
  EXPECT_EQ(daemon.stop(), 0);
  EXPECT_EQ(Json::parse(home_.read("state/hedgehog/state.json"))["clean_stop"], true);
}

}  // namespace
}  // namespace hedgehog::e2e
