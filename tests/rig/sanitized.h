// SPDX-License-Identifier: MIT
// Whether this is a sanitizer's build; g++ and clang say so in different ways. What that shortens.
#pragma once

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define HEDGEHOG_SANITIZED 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer) || \
    __has_feature(memory_sanitizer)
#define HEDGEHOG_SANITIZED 1
#endif
#endif
#ifndef HEDGEHOG_SANITIZED
#define HEDGEHOG_SANITIZED 0
#endif

namespace hedgehog {

/// Of `count` repetitions of the same with other numbers (balls, hours, places) those to make: a
/// sanitizer, with which each takes ten times as long, sees no more in all than in a tenth of them.
template <class Count>
constexpr Count repetitions(Count count) {
  if (HEDGEHOG_SANITIZED == 0) return count;
  return count < 10 ? 1 : count / 10;
}

}  // namespace hedgehog
