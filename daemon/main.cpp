// SPDX-License-Identifier: MIT
// hedgehogd: owns the hardware of one ball.
#include <spdlog/spdlog.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sysexits.h>

#include <csignal>
#include <exception>
#include <filesystem>
#include <iostream>
#include <stdexcept>
#include <string>

#include "daemon/config/load_config.h"
#include "daemon/daemon.h"
#include "daemon/logging.h"
#include "daemon/options.h"
#include "daemon/replay.h"

namespace {

namespace config = hedgehog::config;

/// Exceeds the size of all stacks and the heap.
constexpr rlim_t kLockedBytes = 256u << 20;

/// A page that is fetched from disk, or moved into a huge one, delays a tick.
void lock_memory() {
  prctl(PR_SET_THP_DISABLE, 1, 0, 0, 0);
  rlimit limit{};
  if (getrlimit(RLIMIT_MEMLOCK, &limit) != 0 ||
      (limit.rlim_cur != RLIM_INFINITY && limit.rlim_cur < kLockedBytes) ||
      mlockall(MCL_CURRENT | MCL_FUTURE | MCL_ONFAULT) != 0)
    spdlog::info("memory is not locked (LimitMEMLOCK, ulimit -l)");
}

void make_state_directory(const std::string& path) {
  std::error_code ec;
  std::filesystem::create_directories(path, ec);
  if (ec) throw std::runtime_error(path + ": " + ec.message());
}

int serve(const hedgehog::daemon::Options& options, const config::Paths& paths,
          const config::Config& settings) {
  hedgehog::daemon::start_logging(settings.log_level);
  std::signal(SIGPIPE, SIG_IGN);
  try {
    make_state_directory(settings.state_directory);
    if (!options.speed) lock_memory();
    return hedgehog::daemon::Daemon(options, paths, settings).run();
  } catch (const std::exception& e) {
    spdlog::error("{}", e.what());
    return EX_CANTCREAT;
  }
}

/// The file of a recording "trip-0017", as in the history, in the state directory. An existing file
/// of that name has precedence.
std::string recording_file(const std::string& given, const hedgehog::daemon::Options& options,
                           const config::Paths& paths) {
  std::error_code unseen;
  if (given.find('/') != std::string::npos || std::filesystem::exists(given, unseen)) return given;
  const auto settings = config::load_config(paths, options.overrides);
  const std::filesystem::path place =
      settings.has_error() ? paths.state_directory : settings->state_directory;
  return (place / (given + ".hhr")).string();
}

}  // namespace

int main(int argc, char** argv) {
  const auto parsed = hedgehog::daemon::parse_options(argc, argv);
  if (const int* code = std::get_if<int>(&parsed)) return *code;
  const auto& options = std::get<hedgehog::daemon::Options>(parsed);
  const config::Paths paths =
      config::find_paths(config::process_environment(), options.config_file);
  if (options.replay) {
    return hedgehog::daemon::replay(recording_file(*options.replay, options, paths), std::cout,
                                    std::cerr);
  }
  const auto settings = config::load_config(paths, options.overrides);
  if (settings.has_error()) {
    std::cerr << hedgehog::keys::to_string(settings.error());
    return EX_CONFIG;
  }
  if (options.print_config) std::cout << config::print_config(*settings);
  if (options.print_config || options.check_config) return EX_OK;
  return serve(options, paths, *settings);
}
