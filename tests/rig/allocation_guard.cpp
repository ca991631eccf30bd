// SPDX-License-Identifier: MIT
#include "tests/rig/allocation_guard.h"

#include <dlfcn.h>
#include <pthread.h>

#include <cstddef>
#include <cstdlib>

#include "tests/rig/sanitized.h"

namespace hedgehog::rig {
namespace {

thread_local std::uint64_t count = 0;
thread_local std::uint64_t lock_count = 0;

/// The original function that the one with the same name here replaces.
template <class Lock>
auto behind(const char* name) noexcept {
  return reinterpret_cast<int (*)(Lock*)>(dlsym(RTLD_NEXT, name));
}

}  // namespace

std::uint64_t allocations() noexcept { return count; }
std::uint64_t locks() noexcept { return lock_count; }
bool can_count_allocations() noexcept { return HEDGEHOG_SANITIZED == 0; }

}  // namespace hedgehog::rig

#if !HEDGEHOG_SANITIZED
// glibc's own implementations of the functions replaced here; operator new calls malloc.
extern "C" {
// NOLINTBEGIN(bugprone-reserved-identifier,readability-identifier-naming): the names are glibc's
void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* old, std::size_t size);
void* __libc_memalign(std::size_t alignment, std::size_t size);
// NOLINTEND(bugprone-reserved-identifier,readability-identifier-naming)

void* malloc(std::size_t size) {
  ++hedgehog::rig::count;
  return __libc_malloc(size);
}
void* calloc(std::size_t items, std::size_t size) {
  ++hedgehog::rig::count;
  return __libc_calloc(items, size);
}
void* realloc(void* old, std::size_t size) {
  ++hedgehog::rig::count;
  return __libc_realloc(old, size);
}
void* aligned_alloc(std::size_t alignment, std::size_t size) {
  ++hedgehog::rig::count;
  return __libc_memalign(alignment, size);
}
int pthread_mutex_lock(pthread_mutex_t* mutex) {
  ++hedgehog::rig::lock_count;
  static const auto real = hedgehog::rig::behind<pthread_mutex_t>("pthread_mutex_lock");
  return real(mutex);
}
int pthread_mutex_trylock(pthread_mutex_t* mutex) {
  ++hedgehog::rig::lock_count;
  static const auto real = hedgehog::rig::behind<pthread_mutex_t>("pthread_mutex_trylock");
  return real(mutex);
}
int pthread_rwlock_rdlock(pthread_rwlock_t* lock) {
  ++hedgehog::rig::lock_count;
  static const auto real = hedgehog::rig::behind<pthread_rwlock_t>("pthread_rwlock_rdlock");
  return real(lock);
}
int pthread_rwlock_wrlock(pthread_rwlock_t* lock) {
  ++hedgehog::rig::lock_count;
  static const auto real = hedgehog::rig::behind<pthread_rwlock_t>("pthread_rwlock_wrlock");
  return real(lock);
}
}
#endif
