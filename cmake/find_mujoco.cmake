# SPDX-License-Identifier: BSD-3-Clause
# Target gaitwright_mujoco, if MuJoCo is installed. Debian's mujocoConfig.cmake is not used, because it names a folder
# of headers that is not needed.
find_path(gaitwright_mujoco_headers mujoco/mujoco.h)
find_library(gaitwright_mujoco_library mujoco)
if(gaitwright_mujoco_headers AND gaitwright_mujoco_library AND NOT TARGET gaitwright_mujoco)
  add_library(gaitwright_mujoco UNKNOWN IMPORTED GLOBAL)
  set_target_properties(gaitwright_mujoco PROPERTIES IMPORTED_LOCATION ${gaitwright_mujoco_library}
                        INTERFACE_INCLUDE_DIRECTORIES ${gaitwright_mujoco_headers})
endif()
