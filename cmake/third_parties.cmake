# SPDX-License-Identifier: BSD-3-Clause
# What the libraries and the program are built on. cmake/gaitwrightConfig.cmake.in lists the same for those who link us.
find_package(Eigen3 3.4 REQUIRED)
find_package(fmt REQUIRED)
find_package(utf8cpp REQUIRED)
find_package(yaml-cpp REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(CLI11 REQUIRED)
find_package(fcl REQUIRED)
find_package(Ceres REQUIRED)
find_package(PNG REQUIRED)
find_package(PkgConfig REQUIRED)
pkg_check_modules(urdfdom REQUIRED IMPORTED_TARGET urdfdom)
pkg_check_modules(tinyxml2 REQUIRED IMPORTED_TARGET tinyxml2)
pkg_check_modules(bullet REQUIRED IMPORTED_TARGET bullet-float64)
pkg_check_modules(ompl REQUIRED IMPORTED_TARGET ompl)
pkg_check_modules(minizip REQUIRED IMPORTED_TARGET minizip)
# It asks for an older language than ours.
set_property(TARGET PkgConfig::ompl PROPERTY INTERFACE_COMPILE_OPTIONS "")
