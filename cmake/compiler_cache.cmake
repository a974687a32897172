# SPDX-License-Identifier: BSD-3-Clause
# Compiles through ccache if it is installed. The base directory lets another checkout share the cache.
find_program(GAITWRIGHT_CCACHE ccache)
if(GAITWRIGHT_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env CCACHE_BASEDIR=${CMAKE_SOURCE_DIR} CCACHE_NOHASHDIR=1
      ${GAITWRIGHT_CCACHE})
endif()
