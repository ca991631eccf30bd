// SPDX-License-Identifier: MIT
// Patterns on a real disk: those loaded after a restart, and the effects of a slow or failing disk.
#include "daemon/server/disk/pattern_files.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <spdlog/sinks/stdout_sinks.h>
#include <spdlog/spdlog.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <future>
#include <mutex>

#include "daemon/control/recording/flight_recorder.h"
#include "daemon/server/device/device_view.h"
#include "daemon/server/device/file_state_store.h"
#include "daemon/server/disk/load_saved_state.h"
#include "daemon/server/history/trip_recordings.h"

namespace {

std::mutex synced_mutex;
std::vector<std::string> synced;

}  // namespace

/// Replaces the C library's: records the files that are synchronised to disk.
extern "C" int fsync(int fd) {
  std::error_code unknown;
  const auto path = std::filesystem::read_symlink("/proc/self/fd/" + std::to_string(fd), unknown);
  const std::lock_guard lock(synced_mutex);
  synced.push_back(path.string());
  return static_cast<int>(syscall(SYS_fsync, fd));
}

namespace hedgehog::server {
namespace {

namespace fs = std::filesystem;

class OnDisk : public testing::Test {
 protected:
  OnDisk() {
    fs::create_directory(state_);
    state_ = fs::canonical(state_);
  }
  ~OnDisk() override { fs::remove_all(state_); }

  static std::string pattern(const std::string& name) {
    return protocol::encode_pattern({.name = name, .keyframes = {{.t_ms = 9, .level = 0.5}}});
  }
  void write(const std::string& below, const std::string& text) const {
    const fs::path path = fs::path(state_) / below;
    fs::create_directories(path.parent_path());
    std::ofstream(path) << text;
  }
  std::vector<std::string> names() const {
    DiskThread disk;
    std::vector<std::string> found;
    for (const protocol::Pattern& p : PatternFiles(state_, disk).load()) found.push_back(p.name);
    std::sort(found.begin(), found.end());
    return found;
  }

  std::string state_ = testing::TempDir() + "hedgehog-patterns-" + std::to_string(getpid());
};

TEST_F(OnDisk, ARestartLoadsThemAndSkipsDamagedOnes) {
  {
    DiskThread disk;
    PatternFiles files(state_, disk);
    EXPECT_TRUE(files.load().empty());
    files.keep("acme/knock", pattern("acme/knock"));
    files.keep("acme/gone", pattern("acme/gone"));
    files.drop("acme/gone");
    files.keep("other.json/purr.json", pattern("other.json/purr.json"));
  }
  write("patterns/acme/torn.json", "{\"name\":\"acme/to");
  write("patterns/acme/other.json", pattern("acme/knock"));
  write("patterns/acme/nul.json", pattern("acme/nul") + '\0' + "garbage");
  write("patterns/acme/huge.json", std::string(70'000, ' '));
  write("patterns/acme/cut-off.json.new", "{\"na");
  write("patterns/stray.json", pattern("acme/stray"));
  EXPECT_EQ(names(), (std::vector<std::string>{"acme/knock", "other.json/purr.json"}));
  EXPECT_FALSE(fs::exists(state_ + "/patterns/acme/cut-off.json.new"));
  EXPECT_TRUE(fs::exists(state_ + "/patterns/acme/torn.json")) << "for its owner to mend";
}

TEST_F(OnDisk, OfTooManyTheFirstByNameAreRead) {
  const auto name = [](std::size_t i) { return "acme/" + std::to_string(1000 + i); };
  constexpr std::size_t kMaxPatterns = PatternLibrary::kMaxPut;
  for (std::size_t i = kMaxPatterns + 2; i-- > 0;)
    write("patterns/" + name(i) + ".json", pattern(name(i)));
  DiskThread disk;
  const auto found = PatternFiles(state_, disk).load();
  ASSERT_EQ(found.size(), kMaxPatterns);
  EXPECT_EQ(found.front().name, name(0));
  EXPECT_EQ(found.back().name, name(kMaxPatterns - 1));
}

TEST_F(OnDisk, AFolderThatCannotBeReadHidesNoOther) {
  std::vector<std::string> readable;
  for (const char vendor : std::string("abcdefgh")) {
    readable.push_back(std::string(1, vendor) + "/x");
    write("patterns/" + readable.back() + ".json", pattern(readable.back()));
    write("patterns/locked-" + readable.back() + ".json", "");
    fs::permissions(state_ + "/patterns/locked-" + vendor, fs::perms::none);
  }
  EXPECT_EXIT(
      {
        spdlog::set_default_logger(spdlog::stderr_logger_mt("stderr"));
        constexpr unsigned kNobody = 65534;  // unlike root, subject to file permissions
        if (geteuid() == 0 && setresuid(kNobody, kNobody, kNobody) != 0) std::_Exit(2);
        std::_Exit(names() == readable ? 0 : 1);
      },
      testing::ExitedWithCode(0), "locked-a: Permission denied");
  for (const char vendor : std::string("abcdefgh"))
    fs::permissions(state_ + "/patterns/locked-" + vendor, fs::perms::owner_all);
}

TEST_F(OnDisk, PutAndRemoveAreSyncedWithTheirFolders) {
  const auto synced_by = [&](auto&& what) {
    {
      const std::lock_guard lock(synced_mutex);
      synced.clear();
    }
    {
      DiskThread disk;
      PatternFiles files(state_, disk);
      what(files);
    }
    std::vector<std::string> below;
    for (const std::string& path : synced) below.push_back(path.substr(state_.size()));
    return below;
  };
  using Paths = std::vector<std::string>;
  const auto put = [](const std::string& name) {
    return [name](PatternFiles& files) { files.keep(name, pattern(name)); };
  };
  EXPECT_EQ(synced_by(put("acme/a")),
            (Paths{"", "/patterns", "/patterns/acme/a.json.new", "/patterns/acme"}));
  EXPECT_EQ(synced_by(put("acme/b")), (Paths{"/patterns/acme/b.json.new", "/patterns/acme"}));
  EXPECT_EQ(synced_by([](PatternFiles& files) { files.drop("acme/a"); }), Paths{"/patterns/acme"});
  EXPECT_EQ(synced_by([](PatternFiles& files) { files.drop("acme/b"); }), Paths{"/patterns"});
  EXPECT_FALSE(fs::exists(state_ + "/patterns/acme"));
}

TEST_F(OnDisk, FailuresAreReported) {
  write("patterns/acme", "a file where a folder should be");
  fs::create_directories(state_ + "/patterns/other/full.json/of");
  DiskWorkPtr put;
  DiskWorkPtr removed;
  DiskWorkPtr missing;
  {
    DiskThread disk;
    PatternFiles files(state_, disk);
    put = files.keep("acme/knock", pattern("acme/knock"));
    removed = files.drop("other/full");
    missing = files.drop("third/x");
  }
  EXPECT_NE(put->problem.find("/patterns/acme"), std::string::npos) << put->problem;
  EXPECT_EQ(missing->problem, "");
  EXPECT_NE(removed->problem.find("full.json"), std::string::npos) << removed->problem;
}

TEST_F(OnDisk, ALatchAndATripArePersistedBeforeManyPatterns) {
  const auto mailbox = std::make_unique<control::Mailbox>();
  const auto port = std::make_unique<device::LinkPort>();
  DeviceView device_view(config::Config{}, *mailbox, *port, 0);
  control::FlightRecorder recorder;
  const auto trip = [&] {
    const control::Controller controller{control::ControlSettings{}};
    recorder.before(controller, {});
    recorder.request();
    recorder.after(controller, device::BoardCommand{}, {});
  };
  trip();
  std::promise<void> slow;
  bool persisted_first = false;
  {
    DiskThread disk;
    ASSERT_TRUE(disk.post(DiskUse::kHistory, [wait = slow.get_future().share()] { wait.wait(); }));
    PatternFiles files(state_, disk);
    std::size_t accepted = 0;
    while (files.keep("acme/p" + std::to_string(accepted), pattern("acme/p")) != nullptr)
      ++accepted;
    EXPECT_EQ(accepted, 8u);
    while (disk.post(DiskUse::kScan, [] {})) {
    }
    while (disk.post(DiskUse::kHistory, [] {})) {
    }
    FileStateStore store(state_, disk, device_view, std::nullopt);
    TripRecordings recordings(state_, disk, recorder, 0);
    for (int i = 0; i < 200; ++i) {  // an arbitrary large number of requests
      store.persist_latch(control::Reason::kEmergencyStop);
      recordings.tripped();
    }
    EXPECT_TRUE(disk.post(DiskUse::kSafety, [&] {
      persisted_first = load_saved_state(state_).value_or(SavedState{}).latch ==
                            control::Reason::kEmergencyStop &&
                        fs::exists(state_ + "/trip-0001.hhr") && !fs::exists(state_ + "/patterns");
    }));
    slow.set_value();
  }
  EXPECT_TRUE(persisted_first);
  EXPECT_TRUE(fs::exists(state_ + "/patterns/acme/p7.json"));
}

}  // namespace
}  // namespace hedgehog::server
