// SPDX-License-Identifier: MIT
#include "clients/ctl/demo/private_daemon.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <system_error>
#include <utility>

#include "clients/lib/connection.h"

extern char** environ;

namespace hedgehog::client {

namespace {

namespace fs = std::filesystem;
using std::chrono::milliseconds;

constexpr milliseconds kOneTry{300};
constexpr int kTries = 40;

ClientError cannot_start(const std::string& why) {
  return {Failure::kNoDaemon, "the demo's own daemon did not start: " + why, {}};
}

/// Beside this program (installed), or where the build puts it.
std::string daemon_program() {
  std::error_code failed;
  const fs::path here = fs::read_symlink("/proc/self/exe", failed).parent_path();
  for (const fs::path& candidate : {here / "hedgehogd", here / "../../daemon/hedgehogd"}) {
    if (fs::exists(candidate, failed)) {
      return candidate.string();
    }
  }
  return "hedgehogd";
}

bool write_config(const fs::path& folder, double start_temperature_c) {
  std::ofstream file(folder / "hedgehogd.json");
  file << "{\"backend\": \"simulator\",\n \"state_directory\": " << folder
       << ",\n \"runtime_directory\": " << folder
       << ",\n \"listen\": {\"tcp\": [], \"unix\": \"hedgehogd.sock\"},\n"
          " \"http\": {\"listen\": null},\n"
          " \"simulator\": {\"start_temperature_c\": "
       << start_temperature_c << "}}\n";
  return file.good();
}

/// Its output goes to a file: the terminal belongs to the picture.
pid_t spawn(const std::string& program, const fs::path& folder) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  const std::string log = (folder / "log").string();
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, log.c_str(),
                                   O_WRONLY | O_CREAT | O_APPEND, 0600);
  posix_spawn_file_actions_adddup2(&actions, STDOUT_FILENO, STDERR_FILENO);
  std::string name = program;
  std::string option = "--config";
  std::string config = (folder / "hedgehogd.json").string();
  char* arguments[] = {name.data(), option.data(), config.data(), nullptr};
  // A group of its own: Ctrl-C in the terminal is ours to handle, coils first.
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
  pid_t process = -1;
  const int failed =
      posix_spawnp(&process, program.c_str(), &actions, &attributes, arguments, environ);
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&actions);
  return failed == 0 ? process : -1;
}

std::string log_of(const fs::path& folder) {
  std::ifstream file(folder / "log");
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

}  // namespace

Outcome<PrivateDaemon> PrivateDaemon::start(double start_temperature_c) {
  std::string pattern = (fs::temp_directory_path() / "hedgehog-demo-XXXXXX").string();
  if (mkdtemp(pattern.data()) == nullptr) {
    return cannot_start("no temporary folder: " +
                        std::error_code(errno, std::generic_category()).message());
  }
  PrivateDaemon daemon;
  daemon.folder_ = pattern;
  daemon.socket_ = pattern + "/hedgehogd.sock";
  if (!write_config(pattern, start_temperature_c)) {
    return cannot_start(pattern + " cannot be written");
  }
  const std::string program = daemon_program();
  daemon.process_ = spawn(program, pattern);
  if (daemon.process_ < 0) {
    return cannot_start(program + " cannot be run");
  }
  for (int i = 0; i < kTries; ++i) {
    if (Connection::reopen({Address{.path = daemon.socket_, .host = {}}}, kOneTry)) {
      return daemon;
    }
    int status = 0;
    if (waitpid(daemon.process_, &status, WNOHANG) == daemon.process_) {
      daemon.process_ = -1;
      break;
    }
  }
  return cannot_start(log_of(pattern));
}

PrivateDaemon::PrivateDaemon(PrivateDaemon&& other) noexcept
    : folder_(std::exchange(other.folder_, {})),
      socket_(std::exchange(other.socket_, {})),
      process_(std::exchange(other.process_, -1)) {}

PrivateDaemon::~PrivateDaemon() {
  stop();
  if (!folder_.empty()) {
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
  }
}

int PrivateDaemon::stop() {
  if (process_ < 0) {
    return 0;
  }
  kill(process_, SIGTERM);
  int status = 0;
  pid_t ended = -1;
  do {
    ended = waitpid(process_, &status, 0);
  } while (ended < 0 && errno == EINTR);
  process_ = -1;
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

}  // namespace hedgehog::client
