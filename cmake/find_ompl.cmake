# SPDX-License-Identifier: BSD-3-Clause
# PkgConfig::ompl. Its pkg-config file asks for an older language standard than ours, and for Boost libraries by path.
# Debian's libompl-dev does not install these libraries, and we do not need to link them.
pkg_check_modules(ompl REQUIRED IMPORTED_TARGET ompl)
set_target_properties(PkgConfig::ompl PROPERTIES INTERFACE_COMPILE_OPTIONS "" INTERFACE_LINK_OPTIONS "")
