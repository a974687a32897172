# SPDX-License-Identifier: BSD-3-Clause
# Installs into a prefix of its own, then configures, builds and runs the consumer against it.
set(work ${BINARY_DIR}/tests/consumer)
set(prefix ${work}/prefix)
file(REMOVE_RECURSE ${work})

function(step what)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE status OUTPUT_VARIABLE out ERROR_VARIABLE out)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "${what} failed (${status}):\n${out}")
  endif()
  set(out "${out}" PARENT_SCOPE)
endfunction()

step(install ${CMAKE_COMMAND} --install ${BINARY_DIR} --prefix ${prefix})
step(configure ${CMAKE_COMMAND} -S ${SOURCE_DIR}/tests/consumer -B ${work}/build -G ${GENERATOR}
     -D CMAKE_PREFIX_PATH=${prefix} "-DCMAKE_CXX_FLAGS=${CXX_FLAGS}")
step(build ${CMAKE_COMMAND} --build ${work}/build)
step(run ${work}/build/consumer)
message("${out}")
if(NOT out MATCHES "a1 weighs 1[0-9]\\.[0-9]+ kg")
  message(FATAL_ERROR "the consumer did not print the mass of a1")
endif()
step("the installed program" ${prefix}/bin/gaitwright --version)
