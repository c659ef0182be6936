# permgen_rig(NAME <name> EFFECT <file.fx> FIXTURE <file.json> GOLDENS <folder> [REPORT <folder>]
#             [INCLUDE <folder>...] [DEFINE <NAME[=VALUE]>...])
#
# Tests every technique of an effect: one ctest test each, called <name>.<technique>, draws its passes with the
# fixture's resources and compares them with the goldens in the sources. Failures are shown in <folder>/index.html; the
# tests have the labels rig and vulkan. By default REPORT is rig-report in the build folder, for all effects together.
#
# The target <name>_update_goldens makes the goldens. It fails, because a run that makes its own goldens has tested
# nothing.
#
# PERMGEN_RIG_DRIVER names the manifest of the Vulkan driver that the tests draw with. The default is Mesa's lavapipe if
# it is installed, so that pictures are the same on every machine, with or without a GPU.
file(GLOB permgen_rig_lavapipe LIST_DIRECTORIES false /usr/share/vulkan/icd.d/lvp_icd*.json
     /usr/local/share/vulkan/icd.d/lvp_icd*.json /etc/vulkan/icd.d/lvp_icd*.json)
list(APPEND permgen_rig_lavapipe "")
list(GET permgen_rig_lavapipe 0 permgen_rig_lavapipe)
set(PERMGEN_RIG_DRIVER "${permgen_rig_lavapipe}" CACHE FILEPATH "Vulkan driver manifest that permgen_rig() tests draw with")
unset(permgen_rig_lavapipe)

function(permgen_rig)
  cmake_parse_arguments(PARSE_ARGV 0 rig "" "NAME;EFFECT;FIXTURE;GOLDENS;REPORT" "INCLUDE;DEFINE")
  if(rig_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "permgen_rig: unknown arguments: ${rig_UNPARSED_ARGUMENTS}")
  endif()
  if(NOT rig_NAME OR NOT rig_EFFECT OR NOT rig_FIXTURE OR NOT rig_GOLDENS)
    message(FATAL_ERROR "permgen_rig: NAME <name> EFFECT <file.fx> FIXTURE <file.json> GOLDENS <folder> are required")
  endif()
  if(NOT TARGET permgen::rig)
    message(FATAL_ERROR "permgen_rig: this permgen was built without permgen-rig; build it with TYNDALL_BUILD_APPS=ON")
  endif()
  if(NOT rig_REPORT)
    set(rig_REPORT "${CMAKE_BINARY_DIR}/rig-report")
  endif()
  foreach(path IN ITEMS EFFECT FIXTURE GOLDENS REPORT)
    cmake_path(ABSOLUTE_PATH rig_${path} NORMALIZE)
  endforeach()
  cmake_path(GET rig_EFFECT STEM LAST_ONLY effect)
  set(folder "${CMAKE_CURRENT_BINARY_DIR}/rig/${rig_NAME}")
  set(header "${folder}/${effect}.fx.h")
  set(manifest "${folder}/${effect}.fx.json")

  set(options)
  foreach(include IN LISTS rig_INCLUDE)
    cmake_path(ABSOLUTE_PATH include NORMALIZE)
    list(APPEND options -I "${include}")
  endforeach()
  foreach(define IN LISTS rig_DEFINE)
    list(APPEND options -D "${define}")
  endforeach()
  add_custom_command(
    OUTPUT "${header}"
    BYPRODUCTS "${manifest}"
    COMMAND permgen::permgen compile "${rig_EFFECT}" -o "${folder}" --freeze --depfile "${header}.d" ${options}
    COMMAND ${CMAKE_COMMAND} -E touch "${header}"
    DEPENDS "${rig_EFFECT}" permgen::permgen
    DEPFILE "${header}.d"
    COMMENT "Compiling effect ${effect}.fx for ${rig_NAME}"
    VERBATIM)

  # The list of techniques exists only after the effect is compiled, so ctest reads it when it runs.
  set(tests "${folder}/tests.cmake")
  add_custom_command(
    OUTPUT "${tests}"
    COMMAND ${CMAKE_COMMAND} -D "NAME=${rig_NAME}" -D "RIG=$<TARGET_FILE:permgen::rig>" -D "MANIFEST=${manifest}"
            -D "FIXTURE=${rig_FIXTURE}" -D "GOLDENS=${rig_GOLDENS}" -D "REPORT=${rig_REPORT}"
            -D "DRIVER=${PERMGEN_RIG_DRIVER}" -D "TESTS=${tests}"
            -P "${CMAKE_CURRENT_FUNCTION_LIST_DIR}/PermgenRigTests.cmake"
    DEPENDS "${header}" permgen::rig "${CMAKE_CURRENT_FUNCTION_LIST_DIR}/PermgenRigTests.cmake"
    COMMENT "Listing the techniques of ${effect}.fx for ${rig_NAME}"
    VERBATIM)
  add_custom_target(${rig_NAME}_rig ALL DEPENDS "${tests}")

  file(WRITE "${folder}/include.cmake"
       "if(EXISTS \"${tests}\")\n  include(\"${tests}\")\nelse()\n"
       "  add_test([==[${rig_NAME}.NOT_BUILT]==] \"the target ${rig_NAME}_rig is not built yet\")\n"
       "  set_tests_properties([==[${rig_NAME}.NOT_BUILT]==] PROPERTIES LABELS \"rig;vulkan\")\nendif()\n")
  set_property(DIRECTORY APPEND PROPERTY TEST_INCLUDE_FILES "${folder}/include.cmake")

  set(environment)
  if(PERMGEN_RIG_DRIVER)
    set(environment "VK_DRIVER_FILES=${PERMGEN_RIG_DRIVER}" "VK_ICD_FILENAMES=${PERMGEN_RIG_DRIVER}")
  endif()
  add_custom_target(${rig_NAME}_update_goldens
    COMMAND ${CMAKE_COMMAND} -E env ${environment} $<TARGET_FILE:permgen::rig> "${manifest}" "${rig_FIXTURE}"
            --goldens "${rig_GOLDENS}" --report "${rig_REPORT}" --update-goldens
    DEPENDS "${header}"
    COMMENT "Making the goldens of ${rig_NAME}: this target always fails; look at them, then run the tests"
    VERBATIM)
  add_dependencies(${rig_NAME}_update_goldens ${rig_NAME}_rig)
endfunction()
