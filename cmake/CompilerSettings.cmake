# What every target of this project is compiled with, on an interface target of its own so that nothing
# leaks into a project that includes this one.
add_library(tyndall_compiler_settings INTERFACE)
target_compile_options(tyndall_compiler_settings INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wconversion
                       -Wno-sign-conversion -Wnon-virtual-dtor)
if(TYNDALL_WARNINGS_AS_ERRORS)
  target_compile_options(tyndall_compiler_settings INTERFACE -Werror)
endif()
if(TYNDALL_SANITIZE)
  target_compile_options(tyndall_compiler_settings INTERFACE -fsanitize=address,undefined
                         -fno-sanitize-recover=undefined -fno-omit-frame-pointer)
  target_link_options(tyndall_compiler_settings INTERFACE -fsanitize=address,undefined)
endif()
