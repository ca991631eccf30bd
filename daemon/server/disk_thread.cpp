// SPDX-License-Identifier: MIT
#include "daemon/server/disk_thread.h"

#include <fcntl.h>
#include <pthread.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <utility>

#include "daemon/device/tick_clock.h"

namespace hedgehog::server {

DiskThread::DiskThread(const char* name) {
  const device::SignalsBlocked blocked;
  thread_ = std::thread([this, name] {
    pthread_setname_np(pthread_self(), name);
    run();
  });
}

DiskThread::~DiskThread() {
  {
    const std::lock_guard lock(mutex_);
    stop_ = true;
  }
  changed_.notify_one();
  thread_.join();
}

bool DiskThread::post(DiskUse use, std::function<void()> job) {
  const auto of_use = static_cast<std::size_t>(use);
  {
    const std::lock_guard lock(mutex_);
    if (jobs_[of_use] >= kMostJobs[of_use]) {
      return false;
    }
    ++jobs_[of_use];
    (use == DiskUse::kSafety ? safety_ : others_).push_back({use, std::move(job)});
  }
  changed_.notify_one();
  return true;
}

void DiskThread::run() {
  std::unique_lock lock(mutex_);
  for (;;) {
    changed_.wait(lock, [this] { return stop_ || !safety_.empty() || !others_.empty(); });
    std::deque<Job>& jobs = safety_.empty() ? others_ : safety_;
    if (jobs.empty()) {
      return;
    }
    Job job = std::move(jobs.front());
    jobs.pop_front();
    lock.unlock();
    job.work();
    job.work = nullptr;
    lock.lock();
    --jobs_[static_cast<std::size_t>(job.use)];
  }
}

std::string write_file_atomically(const std::string& path, std::string_view content) {
  const std::string fresh = path + ".new";
  const int fd = ::open(fresh.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0640);
  if (fd < 0) {
    return fresh + ": " + std::strerror(errno);
  }
  bool good = true;
  while (good && !content.empty()) {
    const ssize_t written = ::write(fd, content.data(), content.size());
    good = written > 0 || (written < 0 && errno == EINTR);
    content.remove_prefix(written > 0 ? static_cast<std::size_t>(written) : 0);
  }
  good = good && ::fsync(fd) == 0;
  const int error = errno;
  ::close(fd);
  if (!good) {
    ::unlink(fresh.c_str());
    return fresh + ": " + std::strerror(error);
  }
  if (std::rename(fresh.c_str(), path.c_str()) != 0) {
    std::string problem = path + ": " + std::strerror(errno);
    ::unlink(fresh.c_str());
    return problem;
  }
  return sync_folder(std::filesystem::path(path).parent_path());
}

std::string sync_folder(const std::string& folder) {
  const int at = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (at < 0) {
    return folder + ": " + std::strerror(errno);
  }
  // EINVAL: a file system that has nothing to sync there.
  const int error = ::fsync(at) == 0 || errno == EINVAL ? 0 : errno;
  ::close(at);
  return error == 0 ? std::string() : folder + ": " + std::strerror(error);
}

}  // namespace hedgehog::server
