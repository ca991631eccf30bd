// SPDX-License-Identifier: MIT
// `telemetry.bin` in the state directory: the last minutes of telemetry, written each minute in
// which something has flowed and at an orderly stop. At most 64 KiB.
#pragma once

#include <cstdint>
#include <string>

#include "daemon/server/disk/disk_thread.h"
#include "daemon/server/history/telemetry_samples.h"

namespace hedgehog::server {

/// What is there; empty: nothing, or nothing of that kind. Start-up only.
std::string load_telemetry(const std::string& directory);

/// io thread only; the writing is done by the disk thread.
class TelemetryFile {
 public:
  static constexpr std::int64_t kPeriodMs = 60'000;

  TelemetryFile(const std::string& directory, DiskThread& disk);

  /// After every pump.
  void pump(TelemetrySamples& samples, model::Tick now, std::int64_t unix_ms);
  /// At once. It only informs: a disk that is too slow for it is no fault.
  void write(TelemetrySamples& samples, model::Tick now, std::int64_t unix_ms);

 private:
  std::string path_;
  DiskThread& disk_;
  std::int64_t written_ms_ = 0;
};

}  // namespace hedgehog::server
