# SPDX-License-Identifier: BSD-3-Clause
# The page that shows motions in 3D: npm and esbuild build playback/viewer/web to one script and one style sheet, which
# are embedded in the room playback. Included before the rooms; sets GAITWRIGHT_VIEWER_BUNDLE to the .cc file that
# contains them.
option(GAITWRIGHT_VIEWER "Build the 3D viewer into the program; needs node 18 and npm, and packages of the npm registry" ON)
set(viewer_source ${CMAKE_SOURCE_DIR}/playback/viewer/web)
set(viewer_build ${CMAKE_BINARY_DIR}/viewer)
set(GAITWRIGHT_VIEWER_BUNDLE ${viewer_build}/viewer_bundle.cc)

if(NOT GAITWRIGHT_VIEWER)
  file(CONFIGURE OUTPUT ${GAITWRIGHT_VIEWER_BUNDLE} @ONLY CONTENT [[
// Built without the viewer.
#include "playback/viewer/viewer_bundle_internal.h"
std::string_view gaitwright::ViewerScript() { return {}; }
std::string_view gaitwright::ViewerStyle() { return {}; }
]])
  return()
endif()

find_program(GAITWRIGHT_NODE NAMES node nodejs)
find_program(GAITWRIGHT_NPM npm)
if(NOT GAITWRIGHT_NODE OR NOT GAITWRIGHT_NPM)
  message(FATAL_ERROR "The 3D viewer needs node 18 or newer and npm (Debian: nodejs, npm); or configure with "
                      "-DGAITWRIGHT_VIEWER=OFF for a program without it")
endif()
include(${CMAKE_SOURCE_DIR}/cmake/check_node.cmake)

# npm works in the build tree, so that the source tree does not change.
file(GLOB_RECURSE viewer_scripts CONFIGURE_DEPENDS RELATIVE ${viewer_source} ${viewer_source}/src/*)
set(viewer_inputs "")
foreach(script ${viewer_scripts} build.mjs tsconfig.json)
  list(APPEND viewer_inputs ${viewer_source}/${script})
endforeach()
add_custom_command(
  OUTPUT ${viewer_build}/packages.stamp
  COMMAND ${CMAKE_COMMAND} -E copy ${viewer_source}/package.json ${viewer_source}/package-lock.json ${viewer_source}/.npmrc
          ${viewer_build}
  COMMAND ${GAITWRIGHT_NPM} ci --loglevel=error
  COMMAND ${CMAKE_COMMAND} -E touch ${viewer_build}/packages.stamp
  DEPENDS ${viewer_source}/package.json ${viewer_source}/package-lock.json ${viewer_source}/.npmrc
  WORKING_DIRECTORY ${viewer_build}
  COMMENT "Fetching the packages of the viewer" VERBATIM)
add_custom_command(
  OUTPUT ${GAITWRIGHT_VIEWER_BUNDLE}
  COMMAND ${CMAKE_COMMAND} -E rm -rf src
  COMMAND ${CMAKE_COMMAND} -E copy_directory ${viewer_source}/src src
  COMMAND ${CMAKE_COMMAND} -E copy ${viewer_source}/build.mjs ${viewer_source}/tsconfig.json .
  COMMAND ${GAITWRIGHT_NODE} build.mjs ${GAITWRIGHT_VIEWER_BUNDLE}
  DEPENDS ${viewer_build}/packages.stamp ${viewer_inputs}
  WORKING_DIRECTORY ${viewer_build}
  COMMENT "Building the viewer's page" VERBATIM)
# The texts are long, and ISO C++ requires compilers to accept only 65536 characters.
set_source_files_properties(${GAITWRIGHT_VIEWER_BUNDLE} PROPERTIES COMPILE_OPTIONS "-Wno-overlength-strings")
