# SPDX-License-Identifier: BSD-3-Clause
# The readers of files and flags, fuzzed (docs/hardening.md): a program fuzz_ROOM for each room that has readers. Each
# reader is a test fuzz.NAME: its corpus, and some mutations of it. With GAITWRIGHT_FUZZ (preset `sanitize`, clang) there is
# libfuzzer_ROOM too, the same readers under libFuzzer; `./test --long` runs them.
set(fuzz_room_kinematics gaitwright::kinematics)
set(fuzz_room_planning gaitwright::planning)
set(fuzz_room_playback gaitwright::playback)
set(fuzz_room_workflows gaitwright::workflows)
set(fuzz_room_cli fuzz_cli_numbers)
add_library(fuzz_cli_numbers STATIC ${CMAKE_SOURCE_DIR}/cli/numbers.cc ${CMAKE_SOURCE_DIR}/cli/word_list.cc)
target_link_libraries(fuzz_cli_numbers PUBLIC gaitwright::kinematics fmt::fmt)
target_include_directories(fuzz_cli_numbers PUBLIC ${CMAKE_SOURCE_DIR})

# gaitwright_fuzz(NAME MAIN ROOM PARTS...)
function(gaitwright_fuzz name main room)
  set(folder ${CMAKE_CURRENT_SOURCE_DIR}/fuzz)
  set(sources ${folder}/${main} ${folder}/mutate.cc ${folder}/inputs.cc ${folder}/${room}_readers.cc)
  foreach(part ${ARGN})
    list(APPEND sources ${folder}/${part}.cc)
  endforeach()
  add_executable(${name} ${sources} ${GAITWRIGHT_BUILT_PATHS})
  target_link_libraries(${name} PRIVATE ${fuzz_room_${room}} fmt::fmt)
  target_include_directories(${name} PRIVATE ${CMAKE_SOURCE_DIR})
  target_compile_options(${name} PRIVATE ${GAITWRIGHT_WARNINGS})
endfunction()

# gaitwright_fuzz_room(ROOM PARTS sources... READERS names...)
function(gaitwright_fuzz_room room)
  cmake_parse_arguments(fuzz "" "" "PARTS;READERS" ${ARGN})
  gaitwright_fuzz(fuzz_${room} replay_main.cc ${room} ${fuzz_PARTS})
  foreach(reader ${fuzz_READERS})
    add_test(NAME fuzz.${reader} COMMAND fuzz_${room} ${reader})
    set_tests_properties(fuzz.${reader} PROPERTIES LABELS fuzz)
  endforeach()
  # Every reader of the program is a test.
  list(JOIN fuzz_READERS " [0-9]+\n" pattern)
  add_test(NAME fuzz.${room}.all_readers COMMAND fuzz_${room} --list)
  set_tests_properties(fuzz.${room}.all_readers PROPERTIES LABELS fuzz PASS_REGULAR_EXPRESSION "^${pattern} [0-9]+\n$")
  if(GAITWRIGHT_FUZZ)
    gaitwright_fuzz(libfuzzer_${room} libfuzzer_main.cc ${room} ${fuzz_PARTS})
    target_link_options(libfuzzer_${room} PRIVATE -fsanitize=fuzzer)
  endif()
endfunction()

gaitwright_fuzz_room(kinematics PARTS robot_laws READERS urdf xacro robot_yaml mjcf mesh_stl mesh_obj mesh_dae option)
gaitwright_fuzz_room(planning PARTS plan_laws READERS gaits sequence_text sequence_file terrain_spec terrain_yaml height_csv
                     height_png mesh_ground start_posture plan)
gaitwright_fuzz_room(playback READERS log disturbances outcome network policy_contract policy_commands PARTS policy_readers)
gaitwright_fuzz_room(workflows PARTS exchange_readers recording_readers words_readers grade_readers motion_laws plan_laws READERS motion_csv motion_npz npy compare_csv column_names joint_trajectory
                     joint_trajectory_json footsteps report recording bvh deepmimic contact_plan trials_result axis point candidate journal
                     centroidal_problems options_file live_request task_plan instruction rubric answers code_answer)
gaitwright_fuzz_room(cli READERS numbers)
