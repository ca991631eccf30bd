// SPDX-License-Identifier: MIT
// Whether this is a build with a sanitizer, for g++ and clang; and fewer repetitions for such a
// build.
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

/// How many of `count` repetitions with other values (balls, hours, slots) to run: with a sanitizer
/// each takes ten times as long, and a tenth of them finds the same errors.
template <class Count>
constexpr Count repetitions(Count count) {
  if (HEDGEHOG_SANITIZED == 0) return count;
  return count < 10 ? 1 : count / 10;
}

}  // namespace hedgehog
