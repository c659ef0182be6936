# permgen_effect(TARGET <target> SOURCE <file.fx> [NAMESPACE <ns>] [INCLUDE <folder>...] [DEFINE <NAME[=VALUE]>...]
#                [FREEZE])
#
# Compiles an effect whenever it, a file that it includes or permgen itself has changed. The target can then `#include
# <file.fx.h>`. Call it in the folder that made the target; a target may have several effects. The manifest and the .spv
# files are beside the header, in the folder ${<target>_EFFECTS}.
function(permgen_effect)
  cmake_parse_arguments(PARSE_ARGV 0 effect "FREEZE" "TARGET;SOURCE;NAMESPACE" "INCLUDE;DEFINE")
  if(effect_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "permgen_effect: unknown arguments: ${effect_UNPARSED_ARGUMENTS}")
  endif()
  if(NOT effect_TARGET OR NOT effect_SOURCE)
    message(FATAL_ERROR "permgen_effect: TARGET <target> and SOURCE <file.fx> are required")
  endif()
  if(NOT TARGET ${effect_TARGET})
    message(FATAL_ERROR "permgen_effect: there is no target ${effect_TARGET} (yet)")
  endif()
  # A custom command is known only in the folder that defines it.
  get_target_property(home ${effect_TARGET} SOURCE_DIR)
  if(NOT home STREQUAL CMAKE_CURRENT_SOURCE_DIR)
    message(FATAL_ERROR "permgen_effect: call it in ${home}, where the target ${effect_TARGET} is made")
  endif()

  cmake_path(ABSOLUTE_PATH effect_SOURCE NORMALIZE)
  cmake_path(GET effect_SOURCE STEM LAST_ONLY name)
  set(folder "${CMAKE_CURRENT_BINARY_DIR}/effects/${effect_TARGET}")
  set(header "${folder}/${name}.fx.h")

  set(options)
  if(effect_NAMESPACE)
    list(APPEND options --namespace "${effect_NAMESPACE}")
  endif()
  if(effect_FREEZE)
    list(APPEND options --freeze)
  endif()
  foreach(include IN LISTS effect_INCLUDE)
    cmake_path(ABSOLUTE_PATH include NORMALIZE)
    list(APPEND options -I "${include}")
  endforeach()
  foreach(define IN LISTS effect_DEFINE)
    list(APPEND options -D "${define}")
  endforeach()

  # permgen does not rewrite an unchanged header, so its includers are not compiled again. Ninja still records the step
  # as done; Make compares time stamps.
  set(touch)
  if(NOT CMAKE_GENERATOR MATCHES "Ninja")
    set(touch COMMAND ${CMAKE_COMMAND} -E touch "${header}")
  endif()
  add_custom_command(
    OUTPUT "${header}"
    BYPRODUCTS "${folder}/${name}.fx.json"
    COMMAND permgen::permgen compile "${effect_SOURCE}" -o "${folder}" --depfile "${header}.d" ${options}
    ${touch}
    DEPENDS "${effect_SOURCE}" permgen::permgen
    DEPFILE "${header}.d"
    COMMENT "Compiling effect ${name}.fx for ${effect_TARGET}"
    VERBATIM)

  target_sources(${effect_TARGET} PRIVATE "${header}")
  target_include_directories(${effect_TARGET} PRIVATE "${folder}")
  target_link_libraries(${effect_TARGET} PRIVATE $<BUILD_INTERFACE:permgen::tables>)
  set(${effect_TARGET}_EFFECTS "${folder}" PARENT_SCOPE)
endfunction()
