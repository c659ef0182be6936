# tyndall_test_program() runs this after a program is linked: it writes LIST, the full name of each case of PROGRAM.
# cmake -D PROGRAM=... -D LIST=... -P this
execute_process(COMMAND "${PROGRAM}" --gtest_list_tests RESULT_VARIABLE status OUTPUT_VARIABLE text ERROR_VARIABLE error)
if(NOT status EQUAL 0)
  file(REMOVE "${PROGRAM}")  # so that the next build links it again and comes back here
  message(FATAL_ERROR "${PROGRAM} --gtest_list_tests: ${status}\n${text}${error}")
endif()
string(REGEX REPLACE " *#[^\n]*" "" text "${text}")  # values of parameters
string(REGEX MATCHALL "[^\n]+" lines "${text}")
set(suite "")
set(names "")
foreach(line IN LISTS lines)
  if(line MATCHES "^  (.+)$")
    string(APPEND names "${suite}${CMAKE_MATCH_1}\n")
  else()
    set(suite "${line}")
  endif()
endforeach()
if(names STREQUAL "")
  file(REMOVE "${PROGRAM}")
  message(FATAL_ERROR "${PROGRAM} has no test")
endif()
file(WRITE "${LIST}" "${names}")
