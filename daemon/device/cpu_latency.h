// SPDX-License-Identifier: MIT
// Keeps the processor out of the sleep states that take longer to wake from than a tick can be late
// (Linux, Documentation/power/pm_qos_interface.rst).
#pragma once

#include <string>

#include "daemon/device/socket_transport.h"

namespace hedgehog::device {

/// io thread only.
class CpuLatency {
 public:
  /// Longest wake-up while requested, us.
  static constexpr int kLongestUs = 20;

  explicit CpuLatency(std::string path = "/dev/cpu_dma_latency");

  /// Makes the request, or ends it, as it does when the process ends. Nothing where the system does
  /// not allow it, which is tried once.
  void request(bool wanted) noexcept;
  bool requested() const noexcept { return file_.get() >= 0; }

 private:
  std::string path_;
  FileDescriptor file_;
  bool allowed_ = true;
};

}  // namespace hedgehog::device
