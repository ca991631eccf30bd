// SPDX-License-Identifier: MIT
// Whether this is a sanitizer's build; g++ and clang say so in different ways.
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
