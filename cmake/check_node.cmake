# SPDX-License-Identifier: BSD-3-Clause
# Stops configuring if GAITWRIGHT_NODE is too old for the packages of the viewer. Also usable as a script: cmake -D
# GAITWRIGHT_NODE=FILE -P.
set(oldest_node 18)
execute_process(COMMAND ${GAITWRIGHT_NODE} --version OUTPUT_VARIABLE node_version OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
if(NOT node_version MATCHES "^v([0-9]+)\\." OR CMAKE_MATCH_1 LESS oldest_node)
  message(FATAL_ERROR "The 3D viewer needs node ${oldest_node} or newer, but ${GAITWRIGHT_NODE} is '${node_version}'; give a newer one by "
                      "-DGAITWRIGHT_NODE=FILE, or configure with -DGAITWRIGHT_VIEWER=OFF for a program without it")
endif()
