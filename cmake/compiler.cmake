# SPDX-License-Identifier: MIT
# Language, optimisation and warnings, the same for every target of the tree.

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)

# A project that includes the client library in its own build sets these itself.
if(PROJECT_IS_TOP_LEVEL)
  set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
  # Set explicitly, because libraries and programs must agree for a shared precompiled header.
  add_compile_options(-fPIE)
  add_link_options(-pie)

  if(NOT CMAKE_BUILD_TYPE)
    set(CMAKE_BUILD_TYPE RelWithDebInfo)
  endif()

  # Development builds keep assert(); layers that simulate hours of heat set -O2 themselves (layer.cmake). Line numbers for
  # debuggers cost a tenth of a build: in spite of the build type's name, only those with a sanitizer have them.
  set(CMAKE_CXX_FLAGS_RELWITHDEBINFO "-O0")
  set(CMAKE_CXX_FLAGS_RELEASE "-O2 -DNDEBUG")
  add_compile_definitions($<$<CONFIG:RelWithDebInfo,Debug>:_GLIBCXX_ASSERTIONS>)
  # The hardening of Debian's own programs; no path of the build machine remains in them.
  add_compile_options($<$<CONFIG:Release>:-fstack-protector-strong> "$<$<CONFIG:Release>:-ffile-prefix-map=${CMAKE_SOURCE_DIR}=.>")
  add_compile_definitions($<$<CONFIG:Release>:_FORTIFY_SOURCE=2>)
  add_link_options($<$<CONFIG:Release>:-Wl,-z,relro,-z,now>)
endif()

# A replay must be bit for bit, so no fused multiply-add may appear where the source has none.
add_compile_options(-ffp-contract=off)
include_directories(${PROJECT_SOURCE_DIR})
add_compile_definitions(HEDGEHOG_VERSION="${PROJECT_VERSION}")

if(HEDGEHOG_UNITY)
  set(CMAKE_UNITY_BUILD ON)
  set(CMAKE_UNITY_BUILD_BATCH_SIZE 16 CACHE STRING "Sources in a batch; 0: all of a target")
endif()
if(HEDGEHOG_GUARDS_APART)
  foreach(list guards/guards mutations/scope)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/tests/${list}.txt)
    file(STRINGS ${PROJECT_SOURCE_DIR}/tests/${list}.txt found REGEX "^(file|covered) ")
    list(APPEND HEDGEHOG_ALONE ${found})
  endforeach()
  list(TRANSFORM HEDGEHOG_ALONE REPLACE "^[a-z]+ ([^ ]+).*" "\\1")
endif()

add_library(hedgehog_warnings INTERFACE)
# -Wconversion checks less in g++ than in clang; sign changes are excluded for both.
if(PROJECT_IS_TOP_LEVEL)
  target_compile_options(hedgehog_warnings INTERFACE -Wall -Wextra -Wpedantic -Wconversion -Wno-sign-conversion
                                                     -Wshadow -Werror)
endif()
if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
  # g++ 12 reports overlaps and overruns in std::string that do not exist (its bugs 105329, 105651); AddressSanitizer detects
  # real ones.
  target_compile_options(hedgehog_warnings INTERFACE -Wno-restrict -Wno-array-bounds -Wno-stringop-overflow)
  # g++ treats a source in a batch as an included file, and its anonymous namespace as that of a header.
  if(HEDGEHOG_UNITY)
    target_compile_options(hedgehog_warnings INTERFACE -Wno-subobject-linkage)
  endif()
endif()
