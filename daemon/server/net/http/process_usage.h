// SPDX-License-Identifier: MIT
// What this process uses of the machine, as every Prometheus client library tells it
// (https://prometheus.io/docs/instrumenting/writing_clientlibs/#process-metrics).
#pragma once

#include <optional>

namespace hedgehog::server {

/// nullopt: /proc does not say.
struct ProcessUsage {
  /// User and system time of all threads, s.
  double cpu_s = 0.0;
  std::optional<double> open_fds{};
  std::optional<double> max_fds{};
  std::optional<double> virtual_memory_bytes{};
  std::optional<double> resident_memory_bytes{};
  std::optional<double> threads{};
  /// Seconds since 1970.
  std::optional<double> start_time_s{};
};

/// Some small files of /proc; any thread, never throws.
ProcessUsage process_usage();

}  // namespace hedgehog::server
