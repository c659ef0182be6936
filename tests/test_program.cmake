# googletest programs in ctest. Unlike gtest_discover_tests(), a test runs all cases of a suite in one process: many
# programs take half a second to start, and a Vulkan device as long again. See add_cases.cmake.
option(TYNDALL_TEST_EACH_CASE "A test for each case, in a process of its own" OFF)

# tyndall_test_program(<target> [ENVIRONMENT <NAME=VALUE>]): lists the program's cases whenever it is linked. The program
# also needs a room, see rooms.cmake.
function(tyndall_test_program program)
  cmake_parse_arguments(PARSE_ARGV 1 test "" "ENVIRONMENT" "")
  set(list "${CMAKE_CURRENT_BINARY_DIR}/${program}_cases.txt")
  add_custom_command(
    TARGET ${program} POST_BUILD BYPRODUCTS "${list}"
    COMMAND ${CMAKE_COMMAND} -D "PROGRAM=$<TARGET_FILE:${program}>" -D "LIST=${list}"
            -P "${PROJECT_SOURCE_DIR}/tests/list_cases.cmake"
    VERBATIM)
  set_target_properties(${program} PROPERTIES TYNDALL_CASES "${list}" TYNDALL_ENVIRONMENT "${test_ENVIRONMENT}")
endfunction()

# tyndall_add_cases(<target> LABEL <label> [DRAWS <regular expression>] [COST <regular expression> <seconds>...]): called
# by tyndall_room().
function(tyndall_add_cases program)
  cmake_parse_arguments(PARSE_ARGV 1 cases "" "LABEL;DRAWS" "COST")
  get_target_property(source ${program} SOURCE_DIR)
  get_target_property(folder ${program} BINARY_DIR)
  get_target_property(list ${program} TYNDALL_CASES)
  get_target_property(environment ${program} TYNDALL_ENVIRONMENT)
  set(script "${PROJECT_BINARY_DIR}/tests/rooms/${program}.cmake")
  file(CONFIGURE OUTPUT "${script}" @ONLY CONTENT [==[
set(cases_program "@program@")
set(cases_folder "@folder@")
set(cases_file "@folder@/@program@")
set(cases_list "@list@")
set(cases_environment "@environment@")
set(cases_label "@cases_LABEL@")
set(cases_draws "@cases_DRAWS@")
set(cases_cost "@cases_COST@")
set(cases_each "@TYNDALL_TEST_EACH_CASE@")
include("@PROJECT_SOURCE_DIR@/tests/add_cases.cmake")
]==])
  set_property(DIRECTORY "${source}" APPEND PROPERTY TEST_INCLUDE_FILES "${script}")
endfunction()
