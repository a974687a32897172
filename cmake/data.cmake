# SPDX-License-Identifier: BSD-3-Clause
# The data of the program. The build tree has links to them in the installed layout, so that DataPath finds them there
# as it does below an installation prefix.
set(GAITWRIGHT_BUILD_DATA ${CMAKE_BINARY_DIR}/share/gaitwright)
file(MAKE_DIRECTORY ${GAITWRIGHT_BUILD_DATA})
file(CREATE_LINK ${CMAKE_SOURCE_DIR}/robots ${GAITWRIGHT_BUILD_DATA}/robots SYMBOLIC)
file(CREATE_LINK ${CMAKE_SOURCE_DIR}/planning/gait/gaits.yaml ${GAITWRIGHT_BUILD_DATA}/gaits.yaml SYMBOLIC)
file(CREATE_LINK ${CMAKE_SOURCE_DIR}/tests/benchmarks ${GAITWRIGHT_BUILD_DATA}/benchmarks SYMBOLIC)
set_source_files_properties(kinematics/base/data_path.cc PROPERTIES COMPILE_DEFINITIONS
  "GAITWRIGHT_INSTALLED_DATA=\"${CMAKE_INSTALL_FULL_DATADIR}/gaitwright\";GAITWRIGHT_BUILD_DATA=\"${GAITWRIGHT_BUILD_DATA}\"")
