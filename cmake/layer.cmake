# SPDX-License-Identifier: MIT
# A layer is a folder and a library target. Its sources are the *.cpp of the folder and of those of its subfolders
# that have no CMakeLists.txt of their own; a new file needs no edit here.

# hedgehog_sources(<variable> [EXCEPT <file>...])
function(hedgehog_sources variable)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" EXCEPT)
  file(GLOB found CONFIGURE_DEPENDS RELATIVE ${CMAKE_CURRENT_SOURCE_DIR} *.cpp */*.cpp)
  set(sources "")
  foreach(source IN LISTS found)
    get_filename_component(folder ${source} DIRECTORY)
    if(folder AND EXISTS ${CMAKE_CURRENT_SOURCE_DIR}/${folder}/CMakeLists.txt)
      continue()
    endif()
    if(NOT source IN_LIST arg_EXCEPT)
      list(APPEND sources ${source})
    endif()
  endforeach()
  set(${variable} ${sources} PARENT_SCOPE)
endfunction()

# hedgehog_layer(<target> [FAST] [PCH <owner>] [EXCEPT <file>...] [PUBLIC <target>...] [PRIVATE <target>...])
#   FAST  optimise development builds too: this layer runs inside simulations
#   PCH   reuse the precompiled header of that target
function(hedgehog_layer target)
  cmake_parse_arguments(PARSE_ARGV 1 arg FAST PCH "EXCEPT;PUBLIC;PRIVATE")
  hedgehog_sources(sources EXCEPT ${arg_EXCEPT})
  if(NOT sources)
    add_library(${target} INTERFACE)
    target_link_libraries(${target} INTERFACE ${arg_PUBLIC})
    return()
  endif()
  add_library(${target} STATIC ${sources})
  target_link_libraries(${target} PUBLIC ${arg_PUBLIC} PRIVATE ${arg_PRIVATE} hedgehog_warnings)
  if(arg_FAST)
    target_compile_options(${target} PRIVATE $<$<CONFIG:RelWithDebInfo>:-O2>)
  endif()
  if(arg_PCH)
    hedgehog_reuse_pch(${target} ${arg_PCH})
  endif()
endfunction()

# hedgehog_program(<name> <main.cpp> <target>...): an executable, once its main exists.
function(hedgehog_program name main)
  file(GLOB found CONFIGURE_DEPENDS ${main})
  if(found)
    add_executable(${name} ${main})
    target_link_libraries(${name} PRIVATE ${ARGN} hedgehog_warnings)
  endif()
endfunction()

function(hedgehog_reuse_pch target owner)
  if(HEDGEHOG_PCH AND CMAKE_CXX_COMPILER_ID STREQUAL GNU)
    target_precompile_headers(${target} REUSE_FROM ${owner})
  endif()
endfunction()

# hedgehog_own_pch(<target> <header>...): a header object, compiled once for all who reuse it.
function(hedgehog_own_pch target)
  if(HEDGEHOG_PCH AND CMAKE_CXX_COMPILER_ID STREQUAL GNU)
    target_precompile_headers(${target} PRIVATE ${ARGN})
    target_compile_options(${target} PRIVATE -fpch-preprocess)
  endif()
endfunction()
