// SPDX-License-Identifier: MIT
#include "clients/ctl/demo/private_daemon.h"

#include <fcntl.h>
#include <sys/prctl.h>
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

namespace hedgehog::client {

namespace {

namespace fs = std::filesystem;
using std::chrono::milliseconds;

constexpr milliseconds kAttemptTimeout{300};
/// On a loaded machine it takes seconds until a program has started, and as long until it responds.
constexpr milliseconds kMaxStart{60'000};
constexpr int kCannotRun = 127;

ClientError cannot_start(const std::string& why) {
  return {Failure::kNoDaemon, "the demo's own daemon did not start: " + why, {}};
}

/// In the folder of this program (installed), or in the build folder.
std::string daemon_program() {
  std::error_code failed;
  const fs::path here = fs::read_symlink("/proc/self/exe", failed).parent_path();
  for (const fs::path& candidate : {here / "hedgehogd", here / "../../daemon/hedgehogd"})
    if (fs::exists(candidate, failed)) return candidate.string();
  return "hedgehogd";
}

bool write_config(const fs::path& folder, double start_temperature_c, double ambient_c) {
  std::ofstream file(folder / "hedgehogd.json");
  file << "{\"state_directory\": " << folder << ",\n \"runtime_directory\": " << folder
       << ",\n \"listen\": {\"tcp\": [], \"unix\": \"hedgehogd.sock\"},\n"
          " \"http\": {\"listen\": null},\n"
          " \"simulator\": {\"start_temperature_c\": "
       << start_temperature_c << ", \"ambient_c\": " << ambient_c << "}}\n";
  return file.good();
}

/// In the child: never returns. Its output goes to a file, since the terminal shows the picture.
[[noreturn]] void become(const std::string& program, const fs::path& folder, pid_t parent) {
  // A process group of its own: Ctrl-C in the terminal is handled by this program, coils first. The
  // death signal ends it with the parent.
  setpgid(0, 0);
  prctl(PR_SET_PDEATHSIG, SIGTERM);
  if (getppid() != parent) _exit(kCannotRun);
  const int log = open((folder / "log").c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0600);
  if (log < 0 || dup2(log, STDOUT_FILENO) < 0 || dup2(log, STDERR_FILENO) < 0) _exit(kCannotRun);
  const std::string config = (folder / "hedgehogd.json").string();
  // In lock-step: a busy machine slows the simulation down instead of making it skip ticks.
  execlp(program.c_str(), program.c_str(), "--config", config.c_str(), "--simulate", "--speed", "1",
         nullptr);
  _exit(kCannotRun);
}

pid_t spawn(const std::string& program, const fs::path& folder) {
  const pid_t parent = getpid();
  const pid_t process = fork();
  if (process == 0) become(program, folder, parent);
  return process;
}

std::string log_of(const fs::path& folder) {
  std::ifstream file(folder / "log");
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

}  // namespace

Outcome<PrivateDaemon> PrivateDaemon::start(double start_temperature_c, double ambient_c) {
  std::error_code failed;
  const fs::path temporary = fs::temp_directory_path(failed);
  if (failed) return cannot_start("no temporary folder: " + failed.message());
  std::string pattern = (temporary / "hedgehog-demo-XXXXXX").string();
  if (mkdtemp(pattern.data()) == nullptr) {
    return cannot_start("no temporary folder: " +
                        std::error_code(errno, std::generic_category()).message());
  }
  PrivateDaemon daemon;
  daemon.folder_ = pattern;
  daemon.socket_ = pattern + "/hedgehogd.sock";
  if (!write_config(pattern, start_temperature_c, ambient_c))
    return cannot_start(pattern + " cannot be written");
  const std::string program = daemon_program();
  daemon.process_ = spawn(program, pattern);
  if (daemon.process_ < 0) return cannot_start("no process can be made");
  const auto until = Clock::now() + kMaxStart;
  while (Clock::now() < until) {
    auto connection =
        Connection::reopen({Address{.path = daemon.socket_, .host = {}}}, kAttemptTimeout);
    if (connection) {
      const auto hello = connection->hello("hedgehogctl", std::nullopt, kMaxStart);
      return hello ? Outcome<PrivateDaemon>(std::move(daemon))
                   : cannot_start(hello.error().message);
    }
    int status = 0;
    if (waitpid(daemon.process_, &status, WNOHANG) == daemon.process_) {
      daemon.process_ = -1;
      break;
    }
  }
  const std::string log = log_of(pattern);
  return cannot_start(log.empty() ? program + " cannot be run" : log);
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
  if (process_ < 0) return 0;
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
