# SPDX-License-Identifier: BSD-3-Clause
# cpack runs this for each package, after installing into a folder and before packing the folder.
set(root ${CPACK_TEMPORARY_INSTALL_DIRECTORY})
set(python ${CPACK_GAITWRIGHT_PYTHON_DIR})

if(CPACK_GENERATOR STREQUAL "DEB")
  # Debian's own Python finds packages in one folder for all minor versions.
  set(root ${root}${CPACK_PACKAGING_INSTALL_PREFIX})
  if(python)
    file(MAKE_DIRECTORY ${root}/lib/python3/dist-packages)
    file(RENAME ${root}/${python}/gaitwright ${root}/lib/python3/dist-packages/gaitwright)
    cmake_path(GET python PARENT_PATH python_version)
    file(REMOVE_RECURSE ${root}/${python_version})
  endif()
  configure_file(${root}/share/doc/gaitwright/LICENSE ${root}/share/doc/gaitwright/copyright COPYONLY)
else()
  # An archive contains the shared libraries that a minimal system lacks.
  find_program(interpreter python3 REQUIRED)
  file(GLOB modules ${root}/${python}/gaitwright/_core*.so)
  execute_process(COMMAND ${interpreter} ${CPACK_GAITWRIGHT_BUNDLE} ${root}/lib/gaitwright ${root}/bin/gaitwright ${modules}
                  COMMAND_ERROR_IS_FATAL ANY)
endif()
