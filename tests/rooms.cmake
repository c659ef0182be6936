# Labels and costs of the tests, room by room. ctest prints the time of each label at its end; `ctest -L plan` runs
# one room, `ctest -LE vulkan` what needs no device. Included last: every test is known by then.

# tyndall_room(<label> PROGRAMS <target>... [VULKAN [<regular expression>...]] [COST [<regular expression> <seconds>]...])
#
# PROGRAMS: googletest programs that belong to the room; those that this configuration lacks are skipped.
# VULKAN: their cases that draw; all where no expression follows. COST: long cases, each a test by itself, with a rough
# time in seconds: they start first, so that no core is idle at the end.
function(tyndall_room label)
  cmake_parse_arguments(PARSE_ARGV 1 room "" "" "PROGRAMS;VULKAN;COST")
  string(JOIN "|" draws ${room_VULKAN})
  if("VULKAN" IN_LIST ARGN AND NOT room_VULKAN)
    set(draws ".")
  endif()
  foreach(program IN LISTS room_PROGRAMS)
    if(TARGET ${program})
      tyndall_add_cases(${program} LABEL "${label}" DRAWS "${draws}" COST ${room_COST})
    endif()
  endforeach()
endfunction()

tyndall_room(permgen
             PROGRAMS permgen_front_tests permgen_back_tests permgen_cli_tests permgen_manifest_tests)
tyndall_room(plan PROGRAMS tyndall_plan_test COST "Brightness|Planner.Allocates" 8)
tyndall_room(runtime PROGRAMS tyndall_states_test)
tyndall_room(runtime PROGRAMS tyndall_once_test VULKAN "^RecordMemory")
tyndall_room(runtime PROGRAMS tyndall_record_test tyndall_record_calls_test VULKAN)
tyndall_room(runtime PROGRAMS tyndall_compute_test VULKAN "^Summing")
tyndall_room(planning PROGRAMS tyndall_planning_test VULKAN COST "RapidCheck" 16)
tyndall_room(raycast PROGRAMS tyndall_raycast_test VULKAN COST "RaycastRoom" 60)
tyndall_room(study PROGRAMS tyndall_study_tests)
tyndall_room(apps PROGRAMS tyndall_app_tests
             VULKAN "AccuracyTest" "InMotion" "Images[.]" "^Once" "PipelineCache" "PlannedEqualsForced"
                    "Accumulations" "AutomaticRange" "Formats" "Layers" "Modes[.].*hardware" "Render"
                    "ScatteringPicture" "Slide" "^Command[.]"
             COST "InMotion" 60 "DamagedAnywhere" 17 "AccuracyTest" 7 "PlannedEqualsForced" 6)
tyndall_room(rig PROGRAMS tyndall_rig_test)
tyndall_room(rig PROGRAMS permgen_rig_test VULKAN "^Program" "^PlantedFault")
tyndall_room(permutations PROGRAMS tyndall_oracle_test)
tyndall_room(permutations PROGRAMS tyndall_permutation_test VULKAN COST "/TechniqueTest" 5)
tyndall_room(permutations PROGRAMS tyndall_broken_permutation_test VULKAN COST "ANewAxis" 70 "." 9)

# A test without a label would belong to no room and vanish from the times; a case without a test would not run.
find_package(Python3 3.10 COMPONENTS Interpreter REQUIRED)
add_test(NAME rooms.every_test_has_a_label
         COMMAND ${Python3_EXECUTABLE} "${CMAKE_CURRENT_SOURCE_DIR}/check_labels.py" ${CMAKE_CTEST_COMMAND}
                 "${PROJECT_BINARY_DIR}")
set_tests_properties(rooms.every_test_has_a_label PROPERTIES LABELS rooms)

# Rooms know only the rooms before them: an include that leads back would make a cycle.
function(tyndall_one_way name folder)
    add_test(NAME rooms.${name}
             COMMAND ${Python3_EXECUTABLE} "${CMAKE_CURRENT_SOURCE_DIR}/rooms/check_layers.py" "${PROJECT_SOURCE_DIR}/${folder}"
                     ${ARGN})
    set_tests_properties(rooms.${name} PROPERTIES LABELS rooms)
endfunction()
tyndall_one_way(permgen_includes_go_one_way permgen d3d9 common front lower back emit)
tyndall_one_way(plan_includes_go_one_way plan/src check geometry shape visibility slabs raycast needs)
tyndall_one_way(app_includes_go_one_way apps/tyndall scene frame command)
