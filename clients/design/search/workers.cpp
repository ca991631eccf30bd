// SPDX-License-Identifier: MIT
#include "clients/design/search/workers.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace hedgehog::design {

void parallel_for(std::size_t count, int threads, const std::function<void(std::size_t)>& work,
                  const std::function<void(std::size_t)>& progress) {
  constexpr std::chrono::milliseconds kBetween{100};
  std::atomic<std::size_t> next{0};
  std::mutex mutex;
  std::condition_variable all_done;
  std::size_t done = 0;
  std::exception_ptr first_thrown;
  const auto take = [&] {
    for (std::size_t i = next++; i < count; i = next++) {
      std::exception_ptr thrown;
      try {
        work(i);
      } catch (...) {
        thrown = std::current_exception();
      }
      const std::lock_guard lock(mutex);
      if (thrown && !first_thrown) first_thrown = thrown;
      if (++done == count) all_done.notify_one();
    }
  };
  std::vector<std::jthread> pool;
  for (int i = 0; i < std::max(1, threads); ++i) pool.emplace_back(take);
  std::unique_lock lock(mutex);
  while (done < count) {
    all_done.wait_for(lock, kBetween);
    const std::size_t so_far = done;
    lock.unlock();
    if (so_far < count) progress(so_far);
    lock.lock();
  }
  lock.unlock();
  pool.clear();
  if (first_thrown) std::rethrow_exception(first_thrown);
  progress(count);
}

}  // namespace hedgehog::design
