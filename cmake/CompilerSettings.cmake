# The compiler settings of this project's targets, on an interface target, so that they do not leak into a project that
# includes this one.
add_library(tyndall_compiler_settings INTERFACE)
target_compile_options(tyndall_compiler_settings INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wconversion
                       -Wno-sign-conversion -Wnon-virtual-dtor)
# GCC 12 at -O3 sees impossible copies inside std::string's operator+ (GCC bug 105651). The other presets keep these
# warnings.
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  foreach(warning restrict stringop-overflow array-bounds maybe-uninitialized)
    target_compile_options(tyndall_compiler_settings INTERFACE $<$<CONFIG:Release>:-Wno-${warning}>)
  endforeach()
endif()
if(TYNDALL_WARNINGS_AS_ERRORS)
  target_compile_options(tyndall_compiler_settings INTERFACE -Werror)
endif()
if(TYNDALL_SANITIZE)
  target_compile_options(tyndall_compiler_settings INTERFACE -fsanitize=address,undefined
                         -fno-sanitize-recover=undefined -fno-omit-frame-pointer)
  target_link_options(tyndall_compiler_settings INTERFACE -fsanitize=address,undefined)
endif()
