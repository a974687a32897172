# SPDX-License-Identifier: BSD-3-Clause
# Where the tests are, as a source of its own (tests/built_paths.h).
set(GAITWRIGHT_BUILT_PATHS ${CMAKE_CURRENT_BINARY_DIR}/built_paths.cc)
file(CONFIGURE OUTPUT ${GAITWRIGHT_BUILT_PATHS} @ONLY CONTENT [[
#include "tests/built_paths.h"

namespace gaitwright {

std::string SourceFolder() { return "@CMAKE_SOURCE_DIR@"; }
std::string BuildFolder() { return "@CMAKE_BINARY_DIR@"; }

}  // namespace gaitwright
]])

string(TOUPPER "${CMAKE_BUILD_TYPE}" GAITWRIGHT_BUILD_TYPE_UPPER)

# gaitwright_test_program(NAME ROOM LABEL SHARDS SOURCES... LINKS ...): a program, and tests ROOM.1, ROOM.2, ... that run a
# part of it each (tests/run_shard.py): what its tests share, such as a plan, is made once in a part.
function(gaitwright_test_program name room label shards)
  cmake_parse_arguments(test "" "" "SOURCES;LINKS" ${ARGN})
  add_executable(${name} ${test_SOURCES} ${GAITWRIGHT_BUILT_PATHS})
  target_link_libraries(${name} PRIVATE ${test_LINKS} GTest::gtest_main fmt::fmt)
  target_include_directories(${name} PRIVATE ${CMAKE_SOURCE_DIR})
  target_compile_options(${name} PRIVATE ${GAITWRIGHT_WARNINGS})
  gaitwright_unity(${name} ${test_SOURCES})
  target_compile_options(${name} PRIVATE -fmacro-prefix-map=${CMAKE_SOURCE_DIR}/=)  # GoogleTest has __FILE__ in all tests
  foreach(shard RANGE 1 ${shards})
    if(label STREQUAL "long")
      set(test long.${room}.${shard})
    else()
      set(test ${room}.${shard})
    endif()
    add_test(NAME ${test} COMMAND ${GAITWRIGHT_TEST_PYTHON} ${CMAKE_CURRENT_SOURCE_DIR}/run_shard.py $<TARGET_FILE:${name}>
             --shard ${shard}/${shards} --results ${CMAKE_BINARY_DIR}/test-results/${test}.json)
    set_tests_properties(${test} PROPERTIES LABELS "${label};shard" TIMEOUT 3600)
  endforeach()
endfunction()

# gaitwright_test(ROOM SHARDS LINKS...): one test program a room, ROOM_tests, of every *_test.cc below tests/ROOM with the
# helpers (other .cc files) there. Files called *_long_test.cc make ROOM_long_tests, labelled `long`: only
# `./test --long` runs them. What needs the viewer (*_in_browser_test.cc, viewer_page_test.cc, cli/verb_view_test.cc, cli/verb_live_test.cc, cli/verb_render_test.cc) is left out of a
# build without it, and what is for such a build (without_viewer_test.cc) of all others.
function(gaitwright_test room shards)
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/${room}/*.cc)
  if(NOT DART_FOUND)
    list(FILTER sources EXCLUDE REGEX "dart[a-z_]*\\.cc$")
  endif()
  if(GAITWRIGHT_VIEWER)
    list(FILTER sources EXCLUDE REGEX "without_viewer_test\\.cc$")
  else()
    list(FILTER sources EXCLUDE REGEX "(_in_browser|viewer_page|cli/verb_view|cli/verb_live|cli/verb_render)_test\\.cc$")
  endif()
  if(NOT GAITWRIGHT_HAS_MUJOCO)
    list(FILTER sources EXCLUDE REGEX "/mujoco/")
  endif()
  set(long_tests ${sources})
  set(helpers ${sources})
  set(tests ${sources})
  list(FILTER long_tests INCLUDE REGEX "_long_test\\.cc$")
  list(FILTER tests INCLUDE REGEX "_test\\.cc$")
  list(FILTER tests EXCLUDE REGEX "_long_test\\.cc$")
  list(FILTER helpers EXCLUDE REGEX "_test\\.cc$")
  if(tests)
    gaitwright_test_program(${room}_tests ${room} ${room} ${shards} SOURCES ${tests} ${helpers} LINKS ${ARGN})
  endif()
  if(long_tests)
    gaitwright_test_program(${room}_long_tests ${room} long 2 SOURCES ${long_tests} ${helpers} LINKS ${ARGN})
  endif()
endfunction()
