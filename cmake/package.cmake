# SPDX-License-Identifier: BSD-3-Clause
# cpack, run in the build tree: a Debian package, and an archive that runs from any folder into which it is unpacked.
# docs/install.md describes their installation; tests/package checks them.
install(FILES README.md README.zh.md CHANGELOG.md DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(DIRECTORY docs examples DESTINATION ${CMAKE_INSTALL_DOCDIR} PATTERN "__pycache__" EXCLUDE)

set(CPACK_GENERATOR DEB TGZ)
set(CPACK_PACKAGE_NAME gaitwright)
set(CPACK_PACKAGE_VENDOR "The Gaitwright authors")
set(CPACK_PACKAGE_CONTACT "The Gaitwright authors <maintainers@gaitwright.invalid>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "gait planning for legged robots, checked in physics")
set(CPACK_PACKAGE_DESCRIPTION "Gaitwright makes motion plans for legged robots from a URDF or MJCF, a terrain and a command, audits
them against the limits of the robot, plays them in Bullet and MuJoCo and scores the motion. This package holds the program, the
Python module, robots, gaits, the handbook, and the libraries and headers for programs in C++.")
set(CPACK_PACKAGE_FILE_NAME gaitwright-${PROJECT_VERSION}-linux-${CMAKE_SYSTEM_PROCESSOR})
set(CPACK_RESOURCE_FILE_LICENSE ${CMAKE_SOURCE_DIR}/LICENSE)
set(CPACK_STRIP_FILES ON)
set(CPACK_VERBATIM_VARIABLES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
    OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
# The script converts the installed files into the contents of each package.
set(CPACK_PRE_BUILD_SCRIPTS ${CMAKE_SOURCE_DIR}/cmake/package_stage.cmake)
set(CPACK_GAITWRIGHT_BUNDLE ${CMAKE_SOURCE_DIR}/python/bundle_libraries.py)

set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
# The libraries are static: programs that link them need the headers and libraries of their dependencies, as ./run does.
file(READ cmake/setup.sh setup)
string(REGEX MATCH "program_packages=\"([^\"]*)\"" setup "${setup}")
string(REGEX MATCHALL "[a-z0-9+.-]+-dev" suggested "${CMAKE_MATCH_1}")
list(REMOVE_ITEM suggested libcli11-dev libutfcpp-dev)  # only the program needs these
list(APPEND suggested cmake pkg-config chromium ffmpeg librsvg2-bin)
if(GAITWRIGHT_HAS_MPI)
  list(APPEND suggested libopenmpi-dev openmpi-bin)
endif()
list(JOIN suggested ", " CPACK_DEBIAN_PACKAGE_SUGGESTS)

if(TARGET python_core)
  # A Python module works with one minor version of Python only.
  math(EXPR python_next "${GAITWRIGHT_PYTHON_MINOR} + 1")
  set(CPACK_DEBIAN_PACKAGE_DEPENDS
      "python3 (>= 3.${GAITWRIGHT_PYTHON_MINOR}), python3 (<< 3.${python_next}), python3-numpy")
  set(CPACK_DEBIAN_PACKAGE_RECOMMENDS python3-matplotlib)
  set(CPACK_DEBIAN_PACKAGE_CONTROL_EXTRA ${CMAKE_SOURCE_DIR}/cmake/debian/postinst ${CMAKE_SOURCE_DIR}/cmake/debian/prerm)
  set(CPACK_GAITWRIGHT_PYTHON_DIR ${GAITWRIGHT_PYTHON_DIR})
endif()
include(CPack)
