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
  static constexpr int kLongestUs = 20;  // wake-up while requested

  explicit CpuLatency(std::string path = "/dev/cpu_dma_latency");

  /// Makes or ends the request, as the process's end does. Nothing once the system has refused it.
  void request(bool wanted) noexcept;
  bool requested() const noexcept { return file_.get() >= 0; }

 private:
  std::string path_;
  FileDescriptor file_;
  bool allowed_ = true;
};

}  // namespace hedgehog::device
