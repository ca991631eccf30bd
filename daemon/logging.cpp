// SPDX-License-Identifier: MIT
#include "daemon/logging.h"

#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/sinks/systemd_sink.h>
#include <spdlog/spdlog.h>

#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <memory>

namespace hedgehog::daemon {
namespace {

using control::EventType;

void log_measurement(const control::Event& event) {
  const control::Disagreement& found = event.disagreement;
  const bool thermistor = found.has(control::Quantity::kThermistor);
  const char* const measurement = thermistor ? "the thermistor" : "V/I";
  const char winding = "xyz"[found.coil()];
  if (event.type == EventType::kMeasurementRejected)
    spdlog::warn("winding {}: {} contradicts the heat balance and is not used", winding,
                 measurement);
  else
    spdlog::info("winding {}: {} agrees with the heat balance again", winding, measurement);
}

}  // namespace

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

void log_event(const control::Event& event) {
  switch (event.type) {
    case EventType::kDeratingStarted:
    case EventType::kDeratingEnded:
      spdlog::info("{}: {:.1f} A allowed at {}", control::name(event.type), event.limit_a,
                   std::isfinite(event.temperature_c)
                       ? fmt::format("{:.1f} °C", event.temperature_c)
                       : "an unknown temperature");
      return;
    case EventType::kMeasurementRejected:
    case EventType::kMeasurementAccepted:
      log_measurement(event);
      return;
    case EventType::kOverrun:
      spdlog::warn("the control loop was late: {} ticks skipped", event.count);
      return;
    case EventType::kRejectedNumber:
      spdlog::error("a non-finite number was replaced by zero current");
      return;
    case EventType::kEffectStarted:
    case EventType::kEffectEnded:
    case EventType::kStateChanged:
      return;
    case EventType::kOrientationLost:
    case EventType::kOrientationRestored:
    case EventType::kDeviceAttached:
    case EventType::kDeviceDetached:
      spdlog::info("{}", control::name(event.type));
      return;
  }
}

}  // namespace hedgehog::daemon
