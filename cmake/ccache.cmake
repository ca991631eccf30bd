# SPDX-License-Identifier: MIT
# Compiles through ccache if it is installed; build directories of one checkout share their results.

find_program(HEDGEHOG_CCACHE ccache)
if(HEDGEHOG_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER
      ${CMAKE_COMMAND} -E env
      CCACHE_SLOPPINESS=pch_defines,time_macros
      CCACHE_BASEDIR=${PROJECT_SOURCE_DIR}
      CCACHE_NOHASHDIR=1
      CCACHE_DEPEND=1 # no preprocessing before a compilation: most builds are from scratch
      ${HEDGEHOG_CCACHE})
endif()
