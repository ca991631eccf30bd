// SPDX-License-Identifier: MIT
#include "tests/rig/allocation_guard.h"

#include <cstddef>
#include <cstdlib>

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define HEDGEHOG_COUNTS 0
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer) || \
    __has_feature(memory_sanitizer)
#define HEDGEHOG_COUNTS 0
#endif
#endif
#ifndef HEDGEHOG_COUNTS
#define HEDGEHOG_COUNTS 1
#endif

namespace hedgehog::rig {
namespace {

thread_local std::uint64_t count = 0;

}  // namespace

std::uint64_t allocations() noexcept { return count; }
bool can_count_allocations() noexcept { return HEDGEHOG_COUNTS != 0; }

}  // namespace hedgehog::rig

#if HEDGEHOG_COUNTS
// glibc's own functions behind the ones that are replaced here; operator new calls malloc.
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
}
#endif
