// SPDX-License-Identifier: MIT
#include "tests/soak/state_folder.h"

#include <sched.h>
#include <sys/mount.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <system_error>

#include "tests/soak/damage.h"
#include "tests/soak/failure.h"

namespace hedgehog::soak {
namespace {

namespace fs = std::filesystem;

constexpr const char* kFiller = "/filler";

bool write_text(const char* path, const std::string& text) {
  std::ofstream file(path);
  file << text;
  return static_cast<bool>(file.flush());
}

bool has_own_mounts() {
  if (::geteuid() == 0 && ::unshare(CLONE_NEWNS) == 0) return true;
  const std::string user = std::to_string(::geteuid());
  const std::string group = std::to_string(::getegid());
  return ::unshare(CLONE_NEWUSER | CLONE_NEWNS) == 0 &&
         write_text("/proc/self/setgroups", "deny") &&
         write_text("/proc/self/uid_map", user + " " + user + " 1") &&
         write_text("/proc/self/gid_map", group + " " + group + " 1");
}

bool mount_tmpfs(const std::string& folder) {
  return ::mount("soak", folder.c_str(), "tmpfs", MS_NOSUID | MS_NODEV, "size=512k,mode=0700") == 0;
}

/// Empty when it is not a regular file: opening a FIFO would block until there is a writer.
std::string contents(const std::string& path) {
  std::error_code ec;
  if (!fs::is_regular_file(fs::symlink_status(path, ec))) return {};
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

bool unshare_mounts() {
  return has_own_mounts() && ::mount(nullptr, "/", nullptr, MS_REC | MS_PRIVATE, nullptr) == 0;
}

/// Tried in a child process, because a partial failure would leave this process unusable.
bool child_may_mount() {
  const TemporaryFolder place;
  const pid_t child = ::fork();
  if (child == 0) ::_exit(unshare_mounts() && mount_tmpfs(place.path()) ? 0 : 1);
  int status = 1;
  ::waitpid(child, &status, 0);
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

}  // namespace

bool may_mount() {
  static const bool may = child_may_mount() && unshare_mounts();
  return may;
}

StateFolder::StateFolder(const e2e::Home& home, bool on_small_disk)
    : folder_(fs::path(home.state_file()).parent_path().string()) {
  fs::create_directories(folder_);
  if (!on_small_disk) return;
  if (!mount_tmpfs(folder_)) throw Failure("no disk in memory at " + folder_);
  mounted_ = true;
}

StateFolder::~StateFolder() {
  if (mounted_) ::umount2(folder_.c_str(), MNT_DETACH);
}

void StateFolder::fill() {
  std::ofstream file(folder_ + kFiller, std::ios::binary | std::ios::app);
  // Fills the disk down to the last page.
  const std::string page(4096, 'x');
  while (file.write(page.data(), static_cast<std::streamsize>(page.size())).flush()) {
  }
  full_ = true;
}

void StateFolder::free() {
  std::error_code ignored;
  fs::remove(folder_ + kFiller, ignored);
  full_ = false;
}

bool StateFolder::plant(Random& random) {
  static const std::array<std::string, 10> kNames{
      "state.json",     "state.json.new",        "trips.jsonl",    "events.jsonl",
      "events.jsonl.1", "effects.jsonl",         "derating.jsonl", "recurring.jsonl",
      "telemetry.bin",  "patterns/soak/one.json"};
  const std::string& name = random.pick(kNames);
  const std::string path = folder_ + "/" + name;
  const std::size_t kind = random.below(6);
  const std::string before = contents(path);
  const std::string content =
      kind == 4 ? damaged(random, before) : random.bytes(random.below(100'000));
  std::error_code ec;
  fs::remove_all(path, ec);
  fs::create_directories(fs::path(path).parent_path());
  switch (kind) {
    case 0:
      ::mkfifo(path.c_str(), 0600);
      break;
    case 1:
      fs::create_symlink("/dev/full", path);
      break;
    case 2:
      fs::create_symlink("/dev/zero", path);
      break;
    case 3:
      fs::create_directories(path + "/inside");
      break;
    default:
      std::ofstream(path, std::ios::binary) << content;
  }
  planted_.push_back(path);
  return name == "state.json";
}

void StateFolder::clear() {
  for (const std::string& path : planted_) {
    std::error_code ec;
    if (!fs::is_regular_file(fs::symlink_status(path, ec))) fs::remove_all(path, ec);
  }
  planted_.clear();
}

std::map<std::string, std::string> StateFolder::incomplete() const {
  std::map<std::string, std::string> found;
  for (const auto& entry : fs::recursive_directory_iterator(folder_)) {
    const std::string path = entry.path().string();
    struct stat info {};
    if (!path.ends_with(".new") || ::lstat(path.c_str(), &info) != 0) continue;
    found[path] = std::to_string(info.st_ino) + " " + std::to_string(info.st_mtim.tv_sec) + "." +
                  std::to_string(info.st_mtim.tv_nsec);
  }
  return found;
}

std::string StateFolder::state() const { return contents(folder_ + "/state.json"); }

}  // namespace hedgehog::soak
