# SPDX-License-Identifier: MIT
# HEDGEHOG_SANITIZE=address,undefined or thread; HEDGEHOG_FUZZ adds libFuzzer's instrumentation to the layers that read
# untrusted bytes (hedgehog_layer FUZZED) only: it makes simulated hours take ten times as long.

if(HEDGEHOG_FUZZ)
  if(NOT CMAKE_CXX_COMPILER_ID MATCHES Clang)
    message(FATAL_ERROR "HEDGEHOG_FUZZ needs clang")
  endif()
  # The options that -fsanitize=fuzzer-no-link implies; the compiler rejects it with a precompiled header made without it.
  set(HEDGEHOG_FUZZ_COVERAGE
      -fsanitize-coverage=inline-8bit-counters,indirect-calls,trace-cmp,pc-table,stack-depth
      -fno-builtin-memcmp -fno-builtin-bcmp -fno-builtin-strcmp -fno-builtin-strncmp -fno-builtin-strcasecmp
      -fno-builtin-strncasecmp -fno-builtin-strstr -fno-builtin-strcasestr -fno-builtin-memmem)
endif()

if(HEDGEHOG_SANITIZE)
  # Their reports name lines of the source.
  set(flags -g1 -fsanitize=${HEDGEHOG_SANITIZE} -fno-omit-frame-pointer)
  if(HEDGEHOG_SANITIZE MATCHES undefined)
    list(APPEND flags -fno-sanitize-recover=undefined)
    if(CMAKE_CXX_COMPILER_ID MATCHES Clang)
      # Asio calls handlers through function pointers of another type.
      list(APPEND flags -fno-sanitize=function -fsanitize-ignorelist=${CMAKE_CURRENT_LIST_DIR}/sanitizers_ignore.txt)
    endif()
  endif()
  add_compile_options(${flags})
  add_link_options(${flags})
endif()
