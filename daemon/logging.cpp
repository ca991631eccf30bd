// SPDX-License-Identifier: MIT
#include "daemon/logging.h"

#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/sinks/systemd_sink.h>
#include <spdlog/spdlog.h>

#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdlib>
#include <memory>

namespace hedgehog::daemon {

bool is_journal(const char* stream, int fd) {
  struct stat file {};
  return stream != nullptr && ::fstat(fd, &file) == 0 &&
         fmt::format("{}:{}", file.st_dev, file.st_ino) == stream;
}

void start_logging(config::LogLevel level) {
  if (is_journal(std::getenv("JOURNAL_STREAM"), STDERR_FILENO)) {
    auto sink = std::make_shared<spdlog::sinks::systemd_sink_mt>("hedgehogd", false);
    spdlog::set_default_logger(std::make_shared<spdlog::logger>("hedgehogd", sink));
  } else {
    auto sink = std::make_shared<spdlog::sinks::stderr_color_sink_mt>();
    spdlog::set_default_logger(std::make_shared<spdlog::logger>("hedgehogd", sink));
    spdlog::set_pattern(::isatty(STDERR_FILENO) == 1 ? "%H:%M:%S.%e %^%-7l%$ %v"
                                                     : "%Y-%m-%d %H:%M:%S.%e%z %-7l %v");
  }
  spdlog::flush_on(spdlog::level::info);
  set_log_level(level);
}

void set_log_level(config::LogLevel level) {
  switch (level) {
    case config::LogLevel::kDebug:
      return spdlog::set_level(spdlog::level::debug);
    case config::LogLevel::kInfo:
      return spdlog::set_level(spdlog::level::info);
    case config::LogLevel::kWarning:
      return spdlog::set_level(spdlog::level::warn);
    case config::LogLevel::kError:
      return spdlog::set_level(spdlog::level::err);
  }
}

}  // namespace hedgehog::daemon
