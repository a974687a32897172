# SPDX-License-Identifier: BSD-3-Clause
# One program, gaitwright_benchmarks, of every .cc below tests/benchmarks; ./test --long runs each benchmark briefly.
find_package(benchmark QUIET)
file(GLOB_RECURSE benchmark_sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/benchmarks/*.cc)
if(benchmark_FOUND AND benchmark_sources)
  list(APPEND benchmark_sources ${CMAKE_CURRENT_SOURCE_DIR}/planning/footsteps/grounds.cc)
  add_executable(gaitwright_benchmarks ${benchmark_sources} ${GAITWRIGHT_BUILT_PATHS})
  target_link_libraries(gaitwright_benchmarks PRIVATE gaitwright::workflows benchmark::benchmark_main fmt::fmt)
  target_compile_options(gaitwright_benchmarks PRIVATE ${GAITWRIGHT_WARNINGS})
  gaitwright_unity(gaitwright_benchmarks ${benchmark_sources})
  add_test(NAME benchmarks COMMAND gaitwright_benchmarks --benchmark_min_time=0.1)
  set_tests_properties(benchmarks PROPERTIES LABELS long)
endif()
