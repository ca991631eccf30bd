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

DiskThread::DiskThread() {
  const device::SignalsBlocked blocked;
  thread_ = std::thread([this] {
    pthread_setname_np(pthread_self(), "disk");
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

bool DiskThread::post(std::function<void()> job) {
  {
    const std::lock_guard lock(mutex_);
    if (jobs_.size() >= kMaxJobs) {
      return false;
    }
    jobs_.push_back(std::move(job));
  }
  changed_.notify_one();
  return true;
}

void DiskThread::run() {
  for (;;) {
    std::function<void()> job;
    {
      std::unique_lock lock(mutex_);
      changed_.wait(lock, [this] { return stop_ || !jobs_.empty(); });
      if (jobs_.empty()) {
        return;
      }
      job = std::move(jobs_.front());
      jobs_.pop_front();
    }
    job();
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
    return path + ": " + std::strerror(errno);
  }
  const std::string folder = std::filesystem::path(path).parent_path();
  if (const int at = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC); at >= 0) {
    ::fsync(at);
    ::close(at);
  }
  return {};
}

}  // namespace hedgehog::server
