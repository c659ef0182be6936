# cmake -D BUILD=... -D SOURCE=... -D WORK=... -D GENERATOR=... -D CXX=... -D SANITIZE=... -P this
include("${CMAKE_CURRENT_LIST_DIR}/run.cmake")

file(REMOVE_RECURSE "${WORK}")
file(MAKE_DIRECTORY "${WORK}")
file(COPY "${SOURCE}/" DESTINATION "${WORK}/source")
run(MESSAGE "install" COMMAND ${CMAKE_COMMAND} --install "${BUILD}" --prefix "${WORK}/prefix")
run(MESSAGE "configure"
    COMMAND ${CMAKE_COMMAND} -S "${WORK}/source" -B "${WORK}/build" -G "${GENERATOR}" ${sanitizer_flags}
            -D CMAKE_CXX_COMPILER=${CXX} -D CMAKE_PREFIX_PATH=${WORK}/prefix)
run(MESSAGE "build" COMMAND ${CMAKE_COMMAND} --build "${WORK}/build")
run(MESSAGE "consumer" COMMAND "${WORK}/build/consumer")

# Nothing changed: nothing is compiled again.
run(MESSAGE "second build" COMMAND ${CMAKE_COMMAND} --build "${WORK}/build" OUT again)
if(again MATCHES "tint|main")
  message(FATAL_ERROR "a build after no change did work:\n${again}")
endif()

# The rig: one test for each technique. Without goldens they fail, making goldens fails, and then they pass.
function(rig_must_fail MESSAGE PATTERN)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE status OUTPUT_VARIABLE text ERROR_VARIABLE text)
  if(status EQUAL 0 OR NOT text MATCHES "${PATTERN}")
    message(FATAL_ERROR "${MESSAGE} (${status}):\n${text}")
  endif()
endfunction()
set(rig ${CMAKE_CTEST_COMMAND} --test-dir "${WORK}/build" --output-on-failure)
rig_must_fail("techniques without goldens passed" "plain, pass p0: golden: there is no golden" ${rig})
rig_must_fail("making goldens passed" "picture.exr was made" ${CMAKE_COMMAND} --build "${WORK}/build" --target tint_update_goldens)
run(MESSAGE "rig" COMMAND ${rig} OUT tested)
if(NOT tested MATCHES "100% tests passed, 0 tests failed out of 2" OR NOT tested MATCHES "tint\\.picture ")
  message(FATAL_ERROR "the rig did not try both techniques:\n${tested}")
endif()
file(READ "${WORK}/source/tint.rig.json" fixture)
string(REPLACE "0.25" "0.75" changed "${fixture}")
file(WRITE "${WORK}/source/tint.rig.json" "${changed}")
rig_must_fail("a picture in another colour passed" "plain, pass p0: golden: [^\n]*off by more" ${rig})
if(NOT EXISTS "${WORK}/build/rig-report/index.html")
  message(FATAL_ERROR "a failing technique left no report")
endif()
file(WRITE "${WORK}/source/tint.rig.json" "${fixture}")

# An include changed: the effect is compiled again.
file(APPEND "${WORK}/source/include/tint.fxh" "float4 gMore;\n")
run(MESSAGE "build after a change" COMMAND ${CMAKE_COMMAND} --build "${WORK}/build" OUT changed)
if(NOT changed MATCHES "tint")
  message(FATAL_ERROR "an include changed and the effect was not compiled again:\n${changed}")
endif()

# A misspelt entry point stops the build and names the author's line.
file(READ "${WORK}/source/tint.fx" effect)
string(REPLACE "compile ps_3_0 ps_main(true" "compile ps_3_0 ps_mian(true" effect "${effect}")
file(WRITE "${WORK}/source/tint.fx" "${effect}")
execute_process(COMMAND ${CMAKE_COMMAND} --build "${WORK}/build" RESULT_VARIABLE status
                OUTPUT_VARIABLE text ERROR_VARIABLE text)
if(status EQUAL 0 OR NOT text MATCHES "tint\\.fx:[0-9]+:[0-9]+: error\\[PG[0-9]+\\][^\n]*ps_mian")
  message(FATAL_ERROR "a misspelt entry point was not reported (${status}):\n${text}")
endif()
