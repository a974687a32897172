# SPDX-License-Identifier: BSD-3-Clause
# Installs into a prefix of its own, then configures, builds and runs the consumer against it.
set(work ${BINARY_DIR}/tests/consumer)
set(prefix ${work}/prefix)
file(REMOVE_RECURSE ${work})
# What is shown is that it compiles, links and runs: not optimised, and through ccache where it is installed.
set(compiling "-DCMAKE_CXX_FLAGS=${CXX_FLAGS} -O0")
find_program(ccache ccache)
if(ccache)
  set(ENV{CCACHE_BASEDIR} ${BINARY_DIR})
  set(ENV{CCACHE_NOHASHDIR} 1)
  list(APPEND compiling -D CMAKE_CXX_COMPILER_LAUNCHER=${ccache})
endif()

function(step what)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE status OUTPUT_VARIABLE out ERROR_VARIABLE out)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "${what} failed (${status}):\n${out}")
  endif()
  set(out "${out}" PARENT_SCOPE)
endfunction()

step(install ${CMAKE_COMMAND} --install ${BINARY_DIR} --prefix ${prefix})
step(configure ${CMAKE_COMMAND} -S ${SOURCE_DIR}/tests/consumer -B ${work}/build -G ${GENERATOR}
     -D CMAKE_PREFIX_PATH=${prefix} ${compiling})
step(build ${CMAKE_COMMAND} --build ${work}/build)
step(run ${work}/build/consumer)
message("${out}")
if(NOT out MATCHES "a1 weighs 1[0-9]\\.[0-9]+ kg")
  message(FATAL_ERROR "the consumer did not print the mass of a1")
endif()
step("planning a walk" ${work}/build/planner)
if(NOT out MATCHES "audit: pass")
  message(FATAL_ERROR "the planner's plan does not pass its audit: ${out}")
endif()
file(GET_RUNTIME_DEPENDENCIES EXECUTABLES ${work}/build/planner RESOLVED_DEPENDENCIES_VAR libraries
     UNRESOLVED_DEPENDENCIES_VAR unresolved)
list(FILTER libraries INCLUDE REGEX "Bullet|LinearMath|libcurl|libmpi|boost_(json|beast|program)")
if(libraries)
  message(FATAL_ERROR "planning a walk loads ${libraries}")
endif()

# Which of the large third parties a program loads that links one library: "library=third parties".
set(watched Bullet minizip curl seccomp mpi)
find_program(readelf readelf REQUIRED)
foreach(row kinematics= plan= planning= optimisation= sandbox=seccomp playback=Bullet walk=Bullet study=Bullet preflight=Bullet
        render=Bullet live=Bullet exchange=Bullet,minizip compare=Bullet,minizip words=Bullet,curl cluster=Bullet,mpi
        grade=Bullet,minizip,seccomp formats=Bullet,minizip,seccomp workflows=Bullet,minizip,curl,seccomp,mpi)
  string(REGEX MATCH "^(.*)=(.*)$" row ${row})
  set(room ${CMAKE_MATCH_1})
  string(REPLACE "," ";" wanted "${CMAKE_MATCH_2}")
  if(NOT HAS_MPI)
    list(REMOVE_ITEM wanted mpi)
  endif()
  step("reading links_${room}" ${readelf} --dynamic ${work}/build/links_${room})
  set(found "")
  foreach(library ${watched})
    if(out MATCHES "NEEDED[^\n]*lib${library}")
      list(APPEND found ${library})
    endif()
  endforeach()
  message("gaitwright::${room} loads: ${found}")
  if(NOT "${found}" STREQUAL "${wanted}")
    message(FATAL_ERROR "gaitwright::${room} loads '${found}'; it should load '${wanted}'")
  endif()
endforeach()

# Who asks for one library is not asked for the packages of others.
step("configuring for a library alone" ${CMAKE_COMMAND} -S ${SOURCE_DIR}/tests/consumer/alone -B ${work}/alone -G ${GENERATOR}
     -D CMAKE_PREFIX_PATH=${prefix} -D CMAKE_DISABLE_FIND_PACKAGE_Boost=ON -D CMAKE_DISABLE_FIND_PACKAGE_CURL=ON
     -D CMAKE_DISABLE_FIND_PACKAGE_MPI=ON)
step("building with a library alone" ${CMAKE_COMMAND} --build ${work}/alone)

step("the installed program" ${prefix}/bin/gaitwright --version)

# The course is a project outside of the tree too, as it is handed out: without solutions.
file(COPY ${SOURCE_DIR}/examples/course DESTINATION ${work} PATTERN solutions EXCLUDE)
step("configuring the course" ${CMAKE_COMMAND} -S ${work}/course -B ${work}/course/build -G ${GENERATOR}
     -D CMAKE_PREFIX_PATH=${prefix} ${compiling})
step("building the course" ${CMAKE_COMMAND} --build ${work}/course/build --target course_1_zmp_start)
step("questions for it" ${prefix}/bin/gaitwright grade --rubric ${work}/course/1-zmp/rubric-cpp.yaml --seed 1
     --write-inputs ${work}/questions)
step("its first program" ${work}/course/build/1-zmp/start/zmp ${work}/questions ${work}/answers)
if(NOT EXISTS ${work}/answers/support_margin.csv)
  message(FATAL_ERROR "the course's first program did not answer its questions")
endif()
