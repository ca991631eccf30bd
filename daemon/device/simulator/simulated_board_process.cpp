// SPDX-License-Identifier: MIT
#include "daemon/device/simulator/simulated_board_process.h"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include <filesystem>
#include <system_error>
#include <vector>

#include "base/number_text.h"
#include "daemon/device/simulator/plant_text.h"
#include "daemon/device/simulator/simulated_board_runner.h"

namespace hedgehog::device {
namespace {

constexpr int kChildFd = 3;

std::string beside_own_program() {
  std::error_code error;
  const std::filesystem::path own = std::filesystem::read_symlink("/proc/self/exe", error);
  return (own.parent_path() / "hedgehog-simboard").string();
}

struct SpawnSettings {
  posix_spawn_file_actions_t actions;
  posix_spawnattr_t attributes;

  explicit SpawnSettings(int child_end) {
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, child_end, kChildFd);
    posix_spawnattr_init(&attributes);
    posix_spawnattr_setpgroup(&attributes, 0);
    sigset_t none;
    sigemptyset(&none);
    posix_spawnattr_setsigmask(&attributes, &none);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGMASK);
  }
  SpawnSettings(const SpawnSettings&) = delete;
  SpawnSettings& operator=(const SpawnSettings&) = delete;
  ~SpawnSettings() {
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&actions);
  }
};

}  // namespace

SimulatedBoardProcess::SimulatedBoardProcess(const SimulatedBoardProcessOptions& options) {
  auto [host, child] = make_socket_pair();
  std::vector<std::string> words{
      options.program.empty() ? beside_own_program() : options.program,
      "--fd",
      std::to_string(kChildFd),
      "--start-temperature",
      base::shortest(options.board.start_c),
      "--ambient",
      base::shortest(options.board.ambient_c),
      "--seed",
      std::to_string(options.board.plant.seed),
      "--front-end",
      std::string(name(options.board.front_end.kind)),
      "--thermistors",
      std::to_string(options.board.front_end.thermistors),
      "--parts",
      std::to_string(options.board.front_end.seed),
      "--plant",
      plant_text(options.board.plant),
  };
  if (options.in_step) words.emplace_back("--in-step");
  if (!options.trace.empty()) words.insert(words.end(), {"--trace", options.trace});
  std::vector<char*> arguments;
  arguments.reserve(words.size() + 1);
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);

  const SpawnSettings settings(child.get());
  const int failed = posix_spawn(&pid_, words[0].c_str(), &settings.actions, &settings.attributes,
                                 arguments.data(), environ);
  if (failed != 0) throw std::system_error(failed, std::generic_category(), words[0]);
  transport_ = std::make_unique<SocketTransport>(std::move(host));
}

SimulatedBoardProcess::~SimulatedBoardProcess() {
  transport_.reset();
  const timespec pause{0, 5'000'000};
  for (int waited_ms = 0; waited_ms < SimulatedBoardRunner::kShutdownMs + 1000; waited_ms += 5) {
    if (waitpid(pid_, nullptr, WNOHANG) != 0) return;
    nanosleep(&pause, nullptr);
  }
  kill(pid_, SIGKILL);
  waitpid(pid_, nullptr, 0);
}

}  // namespace hedgehog::device
