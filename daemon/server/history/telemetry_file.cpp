// SPDX-License-Identifier: MIT
#include "daemon/server/history/telemetry_file.h"

#include <spdlog/spdlog.h>

#include <filesystem>
#include <utility>

#include "base/atomic_file.h"
#include "base/regular_file.h"

namespace hedgehog::server {
namespace {

constexpr std::size_t kMaxTelemetryBytes = 64 * 1024;

std::string path_in(const std::string& directory) {
  return (std::filesystem::path(directory) / "telemetry.bin").string();
}

}  // namespace

std::string load_telemetry(const std::string& directory) {
  const std::string path = path_in(directory);
  base::FileText file = base::read_regular_file(path, kMaxTelemetryBytes);
  if (!file.good() && !file.missing)
    spdlog::warn("{}: {}; the telemetry history starts empty", path, file.problem);
  return std::move(file.text);
}

TelemetryFile::TelemetryFile(const std::string& directory, DiskThread& disk)
    : path_(path_in(directory)), disk_(disk) {}

void TelemetryFile::pump(TelemetrySamples& samples, model::Tick now, std::int64_t unix_ms) {
  if (written_ms_ == 0) written_ms_ = unix_ms;
  const bool due = unix_ms - written_ms_ >= kPeriodMs || unix_ms < written_ms_;
  if (due && samples.changed()) write(samples, now, unix_ms);
}

void TelemetryFile::write(TelemetrySamples& samples, model::Tick now, std::int64_t unix_ms) {
  written_ms_ = unix_ms;
  const bool taken =
      disk_.post(DiskUse::kHistory, [path = path_, bytes = samples.encoded(now, unix_ms)] {
        if (const std::string problem = base::write_file_atomically(path, bytes); !problem.empty())
          spdlog::debug("{}: the telemetry history starts empty after a restart", problem);
      });
  if (taken) samples.saved();
}

}  // namespace hedgehog::server
