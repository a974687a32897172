# SPDX-License-Identifier: BSD-3-Clause
# The packages that users install. Only an optimised build with the Python module makes them.
if(NOT CMAKE_BUILD_TYPE STREQUAL "Release" OR NOT TARGET python_core)
  return()
endif()
foreach(tool dpkg-deb dpkg-shlibdeps file patchelf)
  find_program(GAITWRIGHT_TOOL_${tool} ${tool})
  if(NOT GAITWRIGHT_TOOL_${tool})
    message(STATUS "The tests of the packages are left out (Debian: dpkg-dev, file, patchelf)")
    return()
  endif()
endforeach()

set(made ${CMAKE_BINARY_DIR}/tests/package)
set(scripts ${CMAKE_CURRENT_SOURCE_DIR}/package)
add_test(NAME package.make COMMAND ${scripts}/make_packages.sh ${CMAKE_BINARY_DIR} ${made} ${CMAKE_CPACK_COMMAND})
add_test(NAME package.contents COMMAND ${scripts}/check_contents.sh ${made})
add_test(NAME package.archive COMMAND ${scripts}/check_archive.sh ${made})
set_tests_properties(package.make PROPERTIES LABELS package TIMEOUT 3600 FIXTURES_SETUP packages)
set_tests_properties(package.contents package.archive PROPERTIES LABELS package TIMEOUT 3600 FIXTURES_REQUIRED packages)

add_test(NAME package.wheel COMMAND ${scripts}/make_wheel.sh ${CMAKE_BINARY_DIR} ${made}-wheel ${GAITWRIGHT_PYTHON_PROGRAM})
add_test(NAME package.empty_root
         COMMAND ${scripts}/check_in_empty_root.sh ${made} ${made}-wheel ${CMAKE_BINARY_DIR}/empty-root)
set_tests_properties(package.wheel PROPERTIES LABELS "package;long" TIMEOUT 3600 FIXTURES_SETUP wheel)
set_tests_properties(package.empty_root PROPERTIES LABELS "package;long" TIMEOUT 3600 FIXTURES_REQUIRED "packages;wheel"
                     SKIP_REGULAR_EXPRESSION "package check skipped")
