# SPDX-License-Identifier: BSD-3-Clause
# cmake --install: the program, the libraries with their public headers, the robots, and the package for find_package.
include(CMakePackageConfigHelpers)
include(cmake/public_headers.cmake)
set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/gaitwright)

install(TARGETS gaitwright RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(TARGETS ${GAITWRIGHT_ROOMS} EXPORT gaitwrightTargets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(EXPORT gaitwrightTargets NAMESPACE gaitwright:: DESTINATION ${package_dir})

gaitwright_public_headers(public_headers)
foreach(header ${public_headers})
  cmake_path(GET header PARENT_PATH folder)
  install(FILES ${header} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/gaitwright/${folder})
endforeach()
if(EXISTS ${CMAKE_SOURCE_DIR}/robots)
  install(DIRECTORY robots DESTINATION ${CMAKE_INSTALL_DATADIR}/gaitwright)
endif()
if(EXISTS ${CMAKE_SOURCE_DIR}/planning/gait/gaits.yaml)
  install(FILES planning/gait/gaits.yaml DESTINATION ${CMAKE_INSTALL_DATADIR}/gaitwright)
endif()
install(FILES tests/benchmarks/centroidal_problems.json DESTINATION ${CMAKE_INSTALL_DATADIR}/gaitwright/benchmarks)
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})

configure_package_config_file(cmake/gaitwrightConfig.cmake.in ${CMAKE_BINARY_DIR}/gaitwrightConfig.cmake
                              INSTALL_DESTINATION ${package_dir} PATH_VARS CMAKE_INSTALL_DATADIR)
write_basic_package_version_file(${CMAKE_BINARY_DIR}/gaitwrightConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_BINARY_DIR}/gaitwrightConfig.cmake ${CMAKE_BINARY_DIR}/gaitwrightConfigVersion.cmake
              cmake/find_ompl.cmake cmake/find_mujoco.cmake DESTINATION ${package_dir})
