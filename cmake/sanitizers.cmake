# SPDX-License-Identifier: MIT
# HEDGEHOG_SANITIZE=address,undefined or thread; HEDGEHOG_FUZZ adds libFuzzer's instrumentation to the layers that read
# foreign bytes (hedgehog_layer FUZZED): it makes simulated hours ten times as long.

if(HEDGEHOG_FUZZ)
  if(NOT CMAKE_CXX_COMPILER_ID MATCHES Clang)
    message(FATAL_ERROR "HEDGEHOG_FUZZ needs clang")
  endif()
  # What -fsanitize=fuzzer-no-link stands for; that itself would be refused beside a precompiled header without it.
  set(HEDGEHOG_FUZZ_COVERAGE -fsanitize-coverage=inline-8bit-counters,indirect-calls,trace-cmp,pc-table)
endif()

if(HEDGEHOG_SANITIZE)
  set(flags -fsanitize=${HEDGEHOG_SANITIZE} -fno-omit-frame-pointer)
  if(HEDGEHOG_SANITIZE MATCHES undefined)
    # AddressSanitizer sees what object-size sees, which doubles the time of optimised code and sees nothing in other.
    list(APPEND flags -fno-sanitize-recover=undefined -fno-sanitize=object-size)
    if(CMAKE_CXX_COMPILER_ID MATCHES Clang)
      # Asio calls handlers through function pointers of another type.
      list(APPEND flags -fno-sanitize=function)
    endif()
  endif()
  if(HEDGEHOG_SANITIZE MATCHES thread AND CMAKE_CXX_COMPILER_ID STREQUAL GNU)
    # g++ warns about Asio's atomic_thread_fence, which TSan does not model.
    add_compile_options(-Wno-tsan)
  endif()
  add_compile_options(${flags})
  add_link_options(${flags})
endif()
