// SPDX-License-Identifier: MIT
// A thread for blocking disk work, so that io never blocks. A job is not interrupted: a safety job
// waits for one other job of the same thread at most, so no job may take longer than the disk takes
// to write and sync a file (at most 1 MiB). Scans of devices, which may hang, have a thread of
// their own.
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

/// What a job is for. Each use has places of its own, so that none can fill those of another.
enum class DiskUse : std::uint8_t {
  kSafety,    // state, latch, heat, recordings of trips: done before all others
  kHistory,   // what happened: the parts of the event history and the telemetry, one job each
  kLook,      // for devices; never on the thread of kSafety
  kPattern,   // that clients put and remove
  kDownload,  // recordings for web pages
};

/// `post` from the io thread. The destructor does what is still queued.
class DiskThread {
 public:
  /// Jobs of each use that may be queued or under way. Whoever asks for kSafety has one queued at
  /// most, so that it never runs out.
  static constexpr std::array<std::size_t, 5> kMaxJobs{16, 5, 8, 8, 1};

  /// `name`: of the thread, at most 15 characters.
  explicit DiskThread(const char* name = "disk");
  DiskThread(const DiskThread&) = delete;
  DiskThread& operator=(const DiskThread&) = delete;
  ~DiskThread();

  /// False: the disk is so slow that all places of its use are taken; the job is refused. Jobs of
  /// one use are done in order. They must not throw.
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
