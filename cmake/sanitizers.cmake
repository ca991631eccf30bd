# SPDX-License-Identifier: MIT
# HEDGEHOG_SANITIZE=address,undefined or thread; HEDGEHOG_FUZZ adds libFuzzer's instrumentation to the layers that read
# foreign bytes (hedgehog_layer FUZZED): it makes simulated hours ten times as long.

if(HEDGEHOG_FUZZ)
  if(NOT CMAKE_CXX_COMPILER_ID MATCHES Clang)
    message(FATAL_ERROR "HEDGEHOG_FUZZ needs clang")
  endif()
  add_link_options(-fsanitize=fuzzer-no-link)
endif()

if(HEDGEHOG_SANITIZE)
  set(flags -fsanitize=${HEDGEHOG_SANITIZE} -fno-omit-frame-pointer)
  if(HEDGEHOG_SANITIZE MATCHES undefined)
    list(APPEND flags -fno-sanitize-recover=undefined)
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
