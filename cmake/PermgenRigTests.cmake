# permgen_rig() runs this after an effect is compiled: it writes TESTS, ctest's tests for the techniques of MANIFEST.
# cmake -D NAME=... -D RIG=... -D MANIFEST=... -D FIXTURE=... -D GOLDENS=... -D REPORT=... -D DRIVER=... -D TESTS=... -P
# this
execute_process(COMMAND "${RIG}" "${MANIFEST}" --list RESULT_VARIABLE status OUTPUT_VARIABLE text ERROR_VARIABLE text)
if(NOT status EQUAL 0)
  message(FATAL_ERROR "${text}")
endif()
set(environment)
if(DRIVER)
  set(environment "VK_DRIVER_FILES=${DRIVER};VK_ICD_FILENAMES=${DRIVER}")
endif()
string(REGEX MATCHALL "[^\n]+" techniques "${text}")
set(script)
foreach(technique IN LISTS techniques)
  set(test "[==[${NAME}.${technique}]==]")
  string(APPEND script
         "add_test(${test} [==[${RIG}]==] [==[${MANIFEST}]==] [==[${FIXTURE}]==] --technique ${technique} "
         "--goldens [==[${GOLDENS}]==] --report [==[${REPORT}]==])\n"
         "set_tests_properties(${test} PROPERTIES ENVIRONMENT \"${environment}\" TIMEOUT 300 LABELS \"rig;vulkan\")\n")
endforeach()
file(WRITE "${TESTS}" "${script}")
