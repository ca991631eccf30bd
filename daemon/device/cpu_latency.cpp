// SPDX-License-Identifier: MIT
#include "daemon/device/cpu_latency.h"

#include <fcntl.h>
#include <unistd.h>

#include <cstdint>
#include <utility>

namespace hedgehog::device {

CpuLatency::CpuLatency(std::string path) : path_(std::move(path)) {}

void CpuLatency::request(bool wanted) noexcept {
  if (wanted == requested() || (wanted && !allowed_)) return;
  FileDescriptor file(wanted ? ::open(path_.c_str(), O_WRONLY | O_CLOEXEC) : -1);
  const std::int32_t longest_us = kLongestUs;
  allowed_ = !wanted || (file.get() >= 0 &&
                         ::write(file.get(), &longest_us, sizeof longest_us) == sizeof longest_us);
  if (allowed_) file_ = std::move(file);
}

}  // namespace hedgehog::device
