// SPDX-License-Identifier: MIT
// `telemetry.bin` in the state directory: the last minutes of telemetry, written each minute with a
// current and at an orderly stop. At most 64 KiB.
#pragma once

#include <cstdint>
#include <string>

#include "daemon/server/disk/disk_thread.h"
#include "daemon/server/history/telemetry_samples.h"

namespace hedgehog::server {

/// The contents; empty: no file, or an invalid one. Start-up only.
std::string load_telemetry(const std::string& directory);

/// io thread only; the disk thread writes.
class TelemetryFile {
 public:
  static constexpr std::int64_t kPeriodMs = 60'000;

  TelemetryFile(const std::string& directory, DiskThread& disk);

  /// Called after every pump.
  void pump(TelemetrySamples& samples, model::Tick now, std::int64_t unix_ms);
  /// Writes at once. For information only: a disk that is too slow is not a fault.
  void write(TelemetrySamples& samples, model::Tick now, std::int64_t unix_ms);

 private:
  std::string path_;
  DiskThread& disk_;
  std::int64_t written_ms_ = 0;
};

}  // namespace hedgehog::server
