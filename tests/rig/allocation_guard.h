// SPDX-License-Identifier: MIT
// Counts what this thread allocates, operator new and malloc alike, and the locks it takes. Linking
// it replaces malloc and the mutex functions.
#pragma once

#include <cstdint>

namespace hedgehog::rig {

/// Allocations of this thread so far, by any of malloc, calloc, realloc, aligned_alloc and operator
/// new.
std::uint64_t allocations() noexcept;

/// Mutexes and reader-writer locks taken by this thread so far, or tried to be.
std::uint64_t locks() noexcept;

/// True when this build can count both (not under sanitizers, which bring their own malloc).
bool can_count_allocations() noexcept;

}  // namespace hedgehog::rig
