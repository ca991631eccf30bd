// SPDX-License-Identifier: MIT
// Outcome of a job of the disk thread, for io.
#pragma once

#include <atomic>
#include <memory>
#include <string>

namespace hedgehog::server {

/// A job of the disk thread; `problem` is empty on success, and may be read once `done` is true.
struct DiskWork {
  std::atomic<bool> done{false};
  std::string problem;
};
using DiskWorkPtr = std::shared_ptr<DiskWork>;

}  // namespace hedgehog::server
