// SPDX-License-Identifier: MIT
#include "daemon/logging.h"

#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/sinks/systemd_sink.h>
#include <spdlog/spdlog.h>

#include <cstdlib>
#include <memory>

namespace hedgehog::daemon {

void start_logging(config::LogLevel level) {
  if (std::getenv("JOURNAL_STREAM") != nullptr) {
    auto sink = std::make_shared<spdlog::sinks::systemd_sink_mt>("hedgehogd", false);
    spdlog::set_default_logger(std::make_shared<spdlog::logger>("hedgehogd", sink));
  } else {
    auto sink = std::make_shared<spdlog::sinks::stderr_color_sink_mt>();
    spdlog::set_default_logger(std::make_shared<spdlog::logger>("hedgehogd", sink));
    spdlog::set_pattern("%H:%M:%S.%e %^%-7l%$ %v");
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
