# permgen_effect() in a separate project: builds, then does nothing, then rebuilds exactly the parts that a change
# affects. cmake -DPERMGEN_PROGRAM= -DPERMGEN_INCLUDE= -DPERMGEN_EFFECT= -DFIXTURE= -DWORK= -DGENERATOR= -P
# effect_rebuild.cmake
file(REMOVE_RECURSE "${WORK}")
file(COPY "${FIXTURE}/" DESTINATION "${WORK}/source")

function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(status)
    message(FATAL_ERROR "${ARGN}: ${status}\n${output}")
  endif()
  set(output "${output}" PARENT_SCOPE)
endfunction()

function(build_expecting effect_compiled source_compiled)
  # Make's time stamps may have a resolution of one second.
  execute_process(COMMAND ${CMAKE_COMMAND} -E sleep 1.1)
  run(${CMAKE_COMMAND} --build "${WORK}/build" --verbose)
  string(FIND "${output}" "tint.fx -o" effect)
  string(FIND "${output}" "main.cpp.o -c" source)
  foreach(what IN ITEMS effect source)
    if(${what} EQUAL -1)
      set(happened NO)
    else()
      set(happened YES)
    endif()
    if(NOT happened STREQUAL ${${what}_compiled})
      message(FATAL_ERROR "${ARGN}: ${what} compiled: ${happened}, expected ${${what}_compiled}\n${output}")
    endif()
  endforeach()
endfunction()

run(${CMAKE_COMMAND} -S "${WORK}/source" -B "${WORK}/build" -G "${GENERATOR}" -DPERMGEN_PROGRAM=${PERMGEN_PROGRAM}
    -DPERMGEN_INCLUDE=${PERMGEN_INCLUDE} -DPERMGEN_EFFECT=${PERMGEN_EFFECT})
build_expecting(YES YES "first build")
run("${WORK}/build/rebuild")
build_expecting(NO NO "nothing changed")

file(APPEND "${WORK}/source/inc/tint.fxh" "// said once more\n")
if(GENERATOR MATCHES "Ninja")
  build_expecting(YES NO "an included file changed, but not what comes out")
else()
  build_expecting(YES YES "an included file changed")
endif()
build_expecting(NO NO "nothing changed after that")

file(WRITE "${WORK}/source/inc/tint.fxh" "float4 tint(float2 uv) { return float4(uv, 2.0 * LEVEL, 1.0); }\n")
build_expecting(YES YES "an included file changed")
build_expecting(NO NO "nothing changed in the end")
file(REMOVE_RECURSE "${WORK}")
