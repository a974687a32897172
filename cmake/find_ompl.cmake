# SPDX-License-Identifier: BSD-3-Clause
# PkgConfig::ompl. Its pkg-config file asks for an older language than ours, and for libraries of Boost by their paths, which
# Debian's libompl-dev does not bring and which we need not link.
pkg_check_modules(ompl REQUIRED IMPORTED_TARGET ompl)
set_target_properties(PkgConfig::ompl PROPERTIES INTERFACE_COMPILE_OPTIONS "" INTERFACE_LINK_OPTIONS "")
