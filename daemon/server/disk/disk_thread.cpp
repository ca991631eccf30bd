// SPDX-License-Identifier: MIT
#include "daemon/server/disk/disk_thread.h"

#include <pthread.h>

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
    if (jobs_[of_use] >= kMaxJobs[of_use]) return false;
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
    if (jobs.empty()) return;
    Job job = std::move(jobs.front());
    jobs.pop_front();
    lock.unlock();
    job.work();
    job.work = nullptr;
    lock.lock();
    --jobs_[static_cast<std::size_t>(job.use)];
  }
}

}  // namespace hedgehog::server
