// SPDX-License-Identifier: MIT
// The thread that waits for the disk, so that io never does.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <functional>
#include <mutex>
#include <string>
#include <string_view>
#include <thread>

namespace hedgehog::server {

/// `post` from the io thread. The destructor does what is still queued.
class DiskThread {
 public:
  static constexpr std::size_t kMaxJobs = 64;

  DiskThread();
  DiskThread(const DiskThread&) = delete;
  DiskThread& operator=(const DiskThread&) = delete;
  ~DiskThread();

  /// False: the disk is so slow that 64 jobs wait; the job is refused. Jobs must not throw.
  bool post(std::function<void()> job);

 private:
  void run();

  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<std::function<void()>> jobs_;
  bool stop_ = false;
  std::thread thread_;
};

/// Writes beside `path`, syncs, renames: afterwards there is the old content or the new one. An
/// empty string, or what went wrong.
std::string write_file_atomically(const std::string& path, std::string_view content);

}  // namespace hedgehog::server
