// SPDX-License-Identifier: MIT
// Resource usage of this process, as reported by every Prometheus client library
// (https://prometheus.io/docs/instrumenting/writing_clientlibs/#process-metrics).
#pragma once

#include <optional>

namespace hedgehog::server {

/// nullopt: not available in /proc.
struct ProcessUsage {
  double cpu_s = 0.0;  // user and system time of all threads
  std::optional<double> open_fds{};
  std::optional<double> max_fds{};
  std::optional<double> virtual_memory_bytes{};
  std::optional<double> resident_memory_bytes{};
  std::optional<double> threads{};
  std::optional<double> start_time_s{};  // since 1970
};

/// Reads a few small files of /proc; any thread, never throws.
ProcessUsage process_usage();

}  // namespace hedgehog::server
