// SPDX-License-Identifier: MIT
// A thread for blocking disk work, so that io never blocks. A job is not interrupted: a safety job
// waits for one other job of the same thread at most, so no job may take longer than writing and
// syncing a file (at most 1 MiB). Scans of devices, which may hang, have a separate thread.
#pragma once

#include <array>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>

namespace hedgehog::server {

/// Use of a job. Each has its own queue capacity, so that none can fill that of another.
enum class DiskUse : std::uint8_t {
  kSafety,    // state, latch, heat, recordings of trips: before all others
  kHistory,   // the parts of the event history and the telemetry, one job each
  kScan,      // scans of devices; never on the thread of kSafety
  kPattern,   // put and remove by clients
  kDownload,  // recordings for web pages
};

/// `post` from the io thread. The destructor completes the queued jobs.
class DiskThread {
 public:
  /// Maximum queued or running, by use; enough for kSafety: each client has at most one queued.
  static constexpr std::array<std::size_t, 5> kMaxJobs{16, 5, 8, 8, 1};

  /// `name`: of the thread, at most 15 characters.
  explicit DiskThread(const char* name = "disk");
  DiskThread(const DiskThread&) = delete;
  DiskThread& operator=(const DiskThread&) = delete;
  ~DiskThread();

  /// Jobs of one use run in order; they must not throw. False: rejected, its queue is full.
  [[nodiscard]] bool post(DiskUse use, std::function<void()> job);

 private:
  struct Job {
    DiskUse use;
    std::function<void()> work;
  };
  void run();

  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<Job> safety_;
  std::deque<Job> others_;
  std::array<std::size_t, kMaxJobs.size()> jobs_{};  // by use
  bool stop_ = false;
  std::thread thread_;
};

}  // namespace hedgehog::server
