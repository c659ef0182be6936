# cmake -D BUILD=... -D SOURCE=... -D HEADERS=... -D WORK=... -D GENERATOR=... -D CXX=... -D SANITIZE=... -P this
include("${CMAKE_CURRENT_LIST_DIR}/run.cmake")

file(REMOVE_RECURSE "${WORK}")
run(MESSAGE "install" COMMAND ${CMAKE_COMMAND} --install "${BUILD}" --prefix "${WORK}/prefix")
run(MESSAGE "configure"
    COMMAND ${CMAKE_COMMAND} -S "${SOURCE}" -B "${WORK}/build" -G "${GENERATOR}" ${sanitizer_flags}
            -D CMAKE_CXX_COMPILER=${CXX} -D CMAKE_PREFIX_PATH=${WORK}/prefix -D HEADERS=${HEADERS})
run(MESSAGE "build" COMMAND ${CMAKE_COMMAND} --build "${WORK}/build")
run(MESSAGE "plan_consumer" COMMAND "${WORK}/build/plan_consumer" OUT sentence)
if(NOT sentence MATCHES "[a-z]+ [a-z]+")
  message(FATAL_ERROR "no sentence explains the plan: '${sentence}'")
endif()
