# SPDX-License-Identifier: BSD-3-Clause
# The readers of files and flags, fuzzed (docs/hardening.md): a program fuzz_ROOM for each room that has readers. Each
# reader is a test fuzz.NAME: its corpus, and some mutations of it. With GAITWRIGHT_FUZZ (preset `fuzz`, clang) there is
# libfuzzer_ROOM too, the same readers under libFuzzer; `./test --long` runs them.
set(fuzz_room_kinematics gaitwright::kinematics)
set(fuzz_room_planning gaitwright::planning)
set(fuzz_room_playback gaitwright::playback)
set(fuzz_room_workflows gaitwright::workflows)

# gaitwright_fuzz(NAME MAIN ROOM)
function(gaitwright_fuzz name main room)
  set(folder ${CMAKE_CURRENT_SOURCE_DIR}/fuzz)
  set(sources ${folder}/${main} ${folder}/mutate.cc ${folder}/inputs.cc ${folder}/${room}_readers.cc)
  foreach(kind ${ARGN})
    list(APPEND sources ${folder}/${kind}_laws.cc)
  endforeach()
  add_executable(${name} ${sources})
  target_link_libraries(${name} PRIVATE ${fuzz_room_${room}} fmt::fmt)
  target_include_directories(${name} PRIVATE ${CMAKE_SOURCE_DIR})
  target_compile_options(${name} PRIVATE ${GAITWRIGHT_WARNINGS})
  target_compile_definitions(${name} PRIVATE GAITWRIGHT_SOURCE_DIR="${CMAKE_SOURCE_DIR}")
endfunction()

# gaitwright_fuzz_room(ROOM LAWS... READERS names...)
function(gaitwright_fuzz_room room)
  cmake_parse_arguments(fuzz "" "" "LAWS;READERS" ${ARGN})
  gaitwright_fuzz(fuzz_${room} replay_main.cc ${room} ${fuzz_LAWS})
  foreach(reader ${fuzz_READERS})
    add_test(NAME fuzz.${reader} COMMAND fuzz_${room} ${reader})
    set_tests_properties(fuzz.${reader} PROPERTIES LABELS fuzz)
  endforeach()
  # Every reader of the program is a test.
  list(JOIN fuzz_READERS " [0-9]+\n" pattern)
  add_test(NAME fuzz.${room}.all_readers COMMAND fuzz_${room} --list)
  set_tests_properties(fuzz.${room}.all_readers PROPERTIES LABELS fuzz PASS_REGULAR_EXPRESSION "^${pattern} [0-9]+\n$")
  if(GAITWRIGHT_FUZZ)
    gaitwright_fuzz(libfuzzer_${room} libfuzzer_main.cc ${room} ${fuzz_LAWS})
    target_link_options(libfuzzer_${room} PRIVATE -fsanitize=fuzzer)
  endif()
endfunction()

gaitwright_fuzz_room(kinematics LAWS robot READERS urdf robot_yaml mesh_stl mesh_obj mesh_dae option)
gaitwright_fuzz_room(planning LAWS plan READERS gaits sequence_text sequence_file terrain_spec terrain_yaml height_csv
                     height_png mesh_ground plan)
gaitwright_fuzz_room(playback READERS log disturbances outcome)
