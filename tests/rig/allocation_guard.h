// SPDX-License-Identifier: MIT
// Counts what this thread allocates: operator new and malloc alike. Linking it replaces malloc.
#pragma once

#include <cstdint>

namespace hedgehog::rig {

/// Allocations of this thread so far, by any of malloc, calloc, realloc, aligned_alloc and operator
/// new.
std::uint64_t allocations() noexcept;

/// True when this build can count them (not under sanitizers, which bring their own malloc).
bool can_count_allocations() noexcept;

}  // namespace hedgehog::rig
