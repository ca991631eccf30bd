// SPDX-License-Identifier: MIT
// Counts the allocations of this thread, by operator new and malloc alike, and the locks that it
// takes. Linking it replaces malloc and the mutex functions.
#pragma once

#include <cstdint>

namespace hedgehog::rig {

/// Allocations of this thread so far, by any of malloc, calloc, realloc, aligned_alloc and operator
/// new.
std::uint64_t allocations() noexcept;

/// Mutexes and reader-writer locks that this thread has taken so far, or tried to take.
std::uint64_t locks() noexcept;

/// True when this build can count both (false under sanitizers, which have their own malloc).
bool can_count_allocations() noexcept;

}  // namespace hedgehog::rig
